package dev.twister.sky;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;

/** Creates EXIF data with an orientation alone. */
public final class ExifBytes {
    private ExifBytes() {}

    public static byte[] tiff(boolean littleEndian, int orientation) {
        ByteBuffer tiff = ByteBuffer.allocate(38).order(littleEndian ? ByteOrder.LITTLE_ENDIAN : ByteOrder.BIG_ENDIAN);
        tiff.put((byte) (littleEndian ? 'I' : 'M')).put((byte) (littleEndian ? 'I' : 'M'));
        tiff.putShort((short) 42).putInt(8).putShort((short) 2);
        tiff.putShort((short) 0x0100).putShort((short) 4).putInt(1).putInt(7);
        tiff.putShort((short) 0x0112).putShort((short) 3).putInt(1).putShort((short) orientation);
        return tiff.array();
    }
}
