package dev.twister.files;

/** The compression of PNG and OpenEXR files. */
public final class Deflate {
    /** A match of 258 bytes in two bits. */
    private static final int LARGEST_RATIO = 1032;

    private Deflate() {}

    /** Whether data of a length can be a number of bytes, compressed. */
    public static boolean canHold(long compressed, long bytes) {
        return bytes <= compressed * LARGEST_RATIO;
    }
}
