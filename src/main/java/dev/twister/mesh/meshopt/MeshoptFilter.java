package dev.twister.mesh.meshopt;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;

/** Undoes the filters of {@code EXT_meshopt_compression}, which make elements compress better. */
public final class MeshoptFilter {
    private static final float QUATERNION_SCALE = 32_767f / (float) Math.sqrt(2);

    private MeshoptFilter() {}

    /** Unit vectors from their places on an octahedron, four integers each, of which the last stays. */
    public static void octahedral(byte[] elements, int stride) {
        int bytes = stride / 4;
        ByteBuffer buffer = little(elements);
        double largest = bytes == 1 ? 127 : 32_767;
        for (int at = 0; at < elements.length; at += stride) {
            double one = get(buffer, at + 2 * bytes, bytes);
            double x = get(buffer, at, bytes) / one;
            double y = get(buffer, at + bytes, bytes) / one;
            double z = 1 - Math.abs(x) - Math.abs(y);
            double fold = Math.max(-z, 0);
            x -= x >= 0 ? fold : -fold;
            y -= y >= 0 ? fold : -fold;
            double scale = largest / Math.sqrt(x * x + y * y + z * z);
            put(buffer, at, bytes, x * scale);
            put(buffer, at + bytes, bytes, y * scale);
            put(buffer, at + 2 * bytes, bytes, z * scale);
        }
    }

    /** Unit quaternions from their three smaller components, which 16 bits of the fourth explain. */
    public static void quaternion(byte[] elements) {
        ByteBuffer buffer = little(elements);
        for (int at = 0; at < elements.length; at += 8) {
            int meaning = buffer.getShort(at + 6);
            // In floats, so that rounding is the encoder's.
            float scale = QUATERNION_SCALE / (meaning | 3);
            float x = buffer.getShort(at) * scale;
            float y = buffer.getShort(at + 2) * scale;
            float z = buffer.getShort(at + 4) * scale;
            float w = (float) Math.sqrt(Math.max(0, 32_767f * 32_767f - x * x - y * y - z * z));
            int largest = meaning & 3;
            put(buffer, at + 2 * ((largest + 1) % 4), 2, x);
            put(buffer, at + 2 * ((largest + 2) % 4), 2, y);
            put(buffer, at + 2 * ((largest + 3) % 4), 2, z);
            put(buffer, at + 2 * largest, 2, w);
        }
    }

    /** Floats from 24 bits of mantissa and 8 of exponent. */
    public static void exponential(byte[] elements) {
        ByteBuffer buffer = little(elements);
        for (int at = 0; at < elements.length; at += 4) {
            int value = buffer.getInt(at);
            buffer.putFloat(at, (float) Math.scalb((double) ((value << 8) >> 8), value >> 24));
        }
    }

    /** Red, green and blue from luminance and two differences; the highest bit of the opacity tells their scale. */
    public static void color(byte[] elements, int stride) {
        int bytes = stride / 4;
        ByteBuffer buffer = little(elements);
        int mask = (1 << (8 * bytes)) - 1;
        for (int at = 0; at < elements.length; at += stride) {
            int luminance = get(buffer, at, bytes) & mask;
            int orange = get(buffer, at + bytes, bytes);
            int green = get(buffer, at + 2 * bytes, bytes);
            int opacity = get(buffer, at + 3 * bytes, bytes) & mask;
            int largest = 2 * Integer.highestOneBit(Math.max(opacity, 1)) - 1;
            int part = opacity & (largest >> 1);
            double scale = (double) mask / largest;
            put(buffer, at, bytes, (luminance + orange - green) * scale);
            put(buffer, at + bytes, bytes, (luminance + green) * scale);
            put(buffer, at + 2 * bytes, bytes, (luminance - orange - green) * scale);
            put(buffer, at + 3 * bytes, bytes, ((part << 1) | (part & 1)) * scale);
        }
    }

    private static ByteBuffer little(byte[] elements) {
        return ByteBuffer.wrap(elements).order(ByteOrder.LITTLE_ENDIAN);
    }

    private static int get(ByteBuffer buffer, int at, int bytes) {
        return bytes == 1 ? buffer.get(at) : buffer.getShort(at);
    }

    private static void put(ByteBuffer buffer, int at, int bytes, double value) {
        int rounded = (int) (value + (value >= 0 ? 0.5 : -0.5));
        if (bytes == 1) {
            buffer.put(at, (byte) rounded);
        } else {
            buffer.putShort(at, (short) rounded);
        }
    }
}
