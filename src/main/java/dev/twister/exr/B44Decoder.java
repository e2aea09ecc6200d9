package dev.twister.exr;

import dev.twister.exr.ExrPart.ExrFormat;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.zip.DataFormatException;

/** Decompresses B44 and B44A: blocks of 4 x 4 half floats in 14 or, where all are equal, 3 bytes. */
final class B44Decoder {
    private static final int SIDE = 4;
    private static final int BLOCK_BYTES = 14;
    private static final int FLAT_BYTES = 3;
    private static final int FLAT = 13 << 2;
    private static final int STEP_BITS = 6;
    private static final float LARGEST_HALF = 65_504;

    private B44Decoder() {}

    static byte[] decode(byte[] packed, ExrPart part, int width, int height) throws DataFormatException {
        ByteBuffer planes =
                ByteBuffer.allocate(width * height * part.pixelBytes()).order(ByteOrder.LITTLE_ENDIAN);
        int from = 0;
        int plane = 0;
        for (ExrPart.Channel channel : part.channels()) {
            int bytes = width * height * channel.format().bytes();
            if (channel.format() == ExrFormat.HALF) {
                from = blocks(packed, from, planes, plane, width, height, channel.perceptual());
            } else {
                planes.put(plane, packed, from, bytes);
                from += bytes;
            }
            plane += bytes;
        }
        ExrChunkDecoder.check(from == packed.length);
        return ExrChunkDecoder.byRows(planes.array(), part, width, height);
    }

    /** Decodes a channel; returns where its data ends. */
    private static int blocks(
            byte[] packed, int start, ByteBuffer planes, int plane, int width, int height, boolean perceptual) {
        int from = start;
        short[] block = new short[SIDE * SIDE];
        for (int y = 0; y < height; y += SIDE) {
            for (int x = 0; x < width; x += SIDE) {
                boolean flat = (packed[from + 2] & 0xff) >= FLAT;
                unpack(packed, from, flat, block);
                from += flat ? FLAT_BYTES : BLOCK_BYTES;
                for (int i = 0; i < block.length; i++) {
                    int column = x + i % SIDE;
                    int row = y + i / SIDE;
                    if (column < width && row < height) {
                        short value = perceptual ? linear(block[i]) : block[i];
                        planes.putShort(plane + Short.BYTES * (row * width + column), value);
                    }
                }
            }
        }
        return from;
    }

    private static void unpack(byte[] packed, int from, boolean flat, short[] block) {
        int[] ordered = new int[block.length];
        ordered[0] = (packed[from] & 0xff) << Byte.SIZE | (packed[from + 1] & 0xff);
        int shift = (packed[from + 2] & 0xff) >> 2;
        for (int step = 0; step < block.length - 1; step++) {
            boolean down = step < SIDE - 1;
            int to = down ? SIDE * (step + 1) : (step + 1) % SIDE * SIDE + (step + 1) / SIDE;
            int base = ordered[down ? to - SIDE : to - 1];
            ordered[to] = flat ? base : base + ((bits(packed, from, 22 + STEP_BITS * step) - 32) << shift);
        }
        for (int i = 0; i < block.length; i++) {
            // Negative numbers are ordered below positive ones.
            block[i] = (short) ((ordered[i] & 0x8000) != 0 ? ordered[i] & 0x7fff : ~ordered[i]);
        }
    }

    private static int bits(byte[] packed, int from, int bit) {
        int at = from + bit / Byte.SIZE;
        int two = (packed[at] & 0xff) << Byte.SIZE | (at + 1 < packed.length ? packed[at + 1] & 0xff : 0);
        return two >> (2 * Byte.SIZE - STEP_BITS - bit % Byte.SIZE) & (1 << STEP_BITS) - 1;
    }

    private static short linear(short logarithm) {
        float value = Float.float16ToFloat(logarithm);
        if (!Float.isFinite(value)) {
            return 0;
        }
        return Float.floatToFloat16((float) Math.min(LARGEST_HALF, Math.exp(value / 8)));
    }
}
