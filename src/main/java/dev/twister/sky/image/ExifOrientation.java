package dev.twister.sky.image;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;

/** How a camera was held, as EXIF data say (CIPA DC-008, EXIF 2.32). */
final class ExifOrientation {
    static final int UPRIGHT = 1;

    private static final int ORIENTATION = 0x0112;
    private static final int SHORT = 3;
    private static final int LONG = 4;
    private static final int HEADER_BYTES = 8;
    private static final int ENTRY_BYTES = 12;

    private ExifOrientation() {}

    /**
     * The orientation in the first directory of a TIFF structure.
     *
     * @param tiff from its byte order mark on
     * @return 1 to 8; 1 where the data say nothing or make no sense
     */
    static int of(byte[] tiff) {
        if (tiff.length < HEADER_BYTES || tiff[0] != tiff[1] || (tiff[0] != 'I' && tiff[0] != 'M')) {
            return UPRIGHT;
        }
        ByteBuffer data = ByteBuffer.wrap(tiff).order(tiff[0] == 'I' ? ByteOrder.LITTLE_ENDIAN : ByteOrder.BIG_ENDIAN);
        long directory = Integer.toUnsignedLong(data.getInt(4));
        if (data.getShort(2) != 42 || directory > tiff.length - Short.BYTES) {
            return UPRIGHT;
        }
        int entries = Short.toUnsignedInt(data.getShort((int) directory));
        int entry = (int) directory + Short.BYTES;
        for (int i = 0; i < entries && entry <= tiff.length - ENTRY_BYTES; i++) {
            if (Short.toUnsignedInt(data.getShort(entry)) == ORIENTATION) {
                return orientation(data, entry);
            }
            entry += ENTRY_BYTES;
        }
        return UPRIGHT;
    }

    private static int orientation(ByteBuffer data, int entry) {
        int value = switch (data.getShort(entry + 2)) {
            case SHORT -> data.getShort(entry + 8);
            case LONG -> data.getInt(entry + 8);
            default -> UPRIGHT;
        };
        return value >= 1 && value <= 8 ? value : UPRIGHT;
    }
}
