package dev.twister.motion;

import dev.twister.scene.Vector3;
import dev.twister.world.World;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.zip.CRC32C;

/**
 * The positions of the bodies in a frame. In a file: the number of present bodies, the positions as floats, and a
 * CRC-32C of both, little-endian.
 *
 * @param present number of present bodies, including light and plane; the others are not poured yet
 * @param positions {@code float[3 * bodies]}, as the world takes them, relative to the file's origin
 */
@SuppressWarnings("ArrayRecordComponent") // never compared
public record MotionFrame(int present, float[] positions) {
    /**
     * Moves the bodies of a world of the same scene on their straight way to this frame.
     *
     * @param before the frame before this one
     * @param share of the way, in [0, 1]; 1 is this frame
     * @param origin of the positions of both, in the scene's coordinates, in meters
     */
    public void place(World world, MotionFrame before, double share, Vector3 origin) {
        Vector3 shift = origin.minus(world.origin());
        double[] shifts = {shift.x(), shift.y(), shift.z()};
        float[] places = new float[positions.length];
        for (int i = 0; i < places.length; i++) {
            places[i] = (float) ((1 - share) * before.positions[i] + share * positions[i] + shifts[i % 3]);
        }
        world.setBodyPositions(places, present);
    }

    static int bytes(int bodies) {
        return Math.addExact(2 * Integer.BYTES, Math.multiplyExact(3 * Float.BYTES, bodies));
    }

    byte[] encoded() {
        ByteBuffer buffer = ByteBuffer.allocate(bytes(positions.length / 3)).order(ByteOrder.LITTLE_ENDIAN);
        buffer.putInt(present);
        buffer.asFloatBuffer().put(positions);
        int end = buffer.capacity() - Integer.BYTES;
        return buffer.putInt(end, checksum(buffer.array(), end)).array();
    }

    /**
     * Decodes the result of {@link #encoded}.
     *
     * @throws IOException if the checksum is wrong
     */
    static MotionFrame decode(byte[] bytes) throws IOException {
        ByteBuffer buffer = ByteBuffer.wrap(bytes).order(ByteOrder.LITTLE_ENDIAN);
        int end = bytes.length - Integer.BYTES;
        if (buffer.getInt(end) != checksum(bytes, end)) {
            throw new IOException("its checksum is wrong");
        }
        float[] positions = new float[end / Float.BYTES - 1];
        int present = buffer.getInt();
        buffer.asFloatBuffer().get(positions);
        return new MotionFrame(present, positions);
    }

    private static int checksum(byte[] bytes, int end) {
        CRC32C checksum = new CRC32C();
        checksum.update(bytes, 0, end);
        return (int) checksum.getValue();
    }
}
