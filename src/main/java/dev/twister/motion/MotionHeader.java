package dev.twister.motion;

import dev.twister.kernel.Layout;
import dev.twister.scene.Scene;
import dev.twister.scene.Vector3;
import dev.twister.world.World;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.HexFormat;
import java.util.zip.CRC32C;

/**
 * The header of a motion file: {@value #BYTES} bytes, little-endian.
 *
 * @param digest hexadecimal {@link MotionDigest} of the scene
 * @param bodies number of bodies: light, plane and all spheres, including those not poured yet
 * @param firstFrame number of the first frame in the file, at least 0
 * @param rate frames per second
 * @param origin origin of the positions, in the scene's coordinates, in meters
 */
record MotionHeader(String digest, int bodies, int firstFrame, double rate, Vector3 origin) {
    static final int BYTES = 128;

    private static final byte[] MAGIC = "TWISTER MOTION 1".getBytes(StandardCharsets.US_ASCII);
    private static final int CHECKSUM_AT = BYTES - Integer.BYTES;

    static MotionHeader of(Scene scene, int firstFrame, double rate) {
        return new MotionHeader(
                HexFormat.of().formatHex(MotionDigest.of(scene)),
                Layout.FIRST_SPHERE + scene.allSpheres().size(),
                firstFrame,
                rate,
                World.originOf(scene));
    }

    byte[] encoded() {
        ByteBuffer buffer = ByteBuffer.allocate(BYTES).order(ByteOrder.LITTLE_ENDIAN);
        buffer.put(MAGIC).put(HexFormat.of().parseHex(digest)).putInt(bodies).putInt(firstFrame);
        buffer.putDouble(rate).putDouble(origin.x()).putDouble(origin.y()).putDouble(origin.z());
        return buffer.putInt(CHECKSUM_AT, checksum(buffer.array())).array();
    }

    /**
     * Decodes the result of {@link #encoded}.
     *
     * @param bytes {@value #BYTES} bytes
     * @throws IOException if they are not a header
     */
    static MotionHeader decode(byte[] bytes) throws IOException {
        ByteBuffer buffer = ByteBuffer.wrap(bytes).order(ByteOrder.LITTLE_ENDIAN);
        byte[] magic = new byte[MAGIC.length];
        buffer.get(magic);
        if (!Arrays.equals(magic, MAGIC) || buffer.getInt(CHECKSUM_AT) != checksum(bytes)) {
            throw new IOException("not a motion file of this version of Twister");
        }
        byte[] digest = new byte[MotionDigest.BYTES];
        buffer.get(digest);
        return new MotionHeader(
                HexFormat.of().formatHex(digest),
                buffer.getInt(),
                buffer.getInt(),
                buffer.getDouble(),
                new Vector3(buffer.getDouble(), buffer.getDouble(), buffer.getDouble()));
    }

    /** Size of each frame in the file, in bytes. */
    int frameBytes() {
        return MotionFrame.bytes(bodies);
    }

    private static int checksum(byte[] header) {
        CRC32C checksum = new CRC32C();
        checksum.update(header, 0, CHECKSUM_AT);
        return (int) checksum.getValue();
    }
}
