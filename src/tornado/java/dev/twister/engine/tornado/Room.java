package dev.twister.engine.tornado;

/** Lengths of buffers on devices, with room for larger pictures and more bodies, which then need no other kernel. */
final class Room {
    /** Pictures up to 1920 x 1080, 3840 x 2160 and 7680 x 4320 have room in these numbers of pixels. */
    private static final int[] PIXELS = {1 << 21, 1 << 23, 1 << 25};

    private static final int LEAST_FLOATS = 1024;

    private Room() {}

    /** A buffer's length for a number of pixels: a step that is at least as large, or the number itself. */
    static int ofPixels(int pixels) {
        for (int step : PIXELS) {
            if (pixels <= step) {
                return step;
            }
        }
        return pixels;
    }

    /** A buffer's length for a number of floats: a quarter more, which little lengthens the copy of each frame. */
    static int ofFloats(int floats) {
        return (int) Math.min(Integer.MAX_VALUE - 8L, (long) floats + Math.max(LEAST_FLOATS, floats / 4));
    }

    /** Whether floats fit in a buffer, without the buffer being so large that its copies take long. */
    static boolean fits(int buffer, int floats) {
        return floats <= buffer && buffer <= 4L * ofFloats(floats);
    }
}
