package dev.twister.cli;

import dev.twister.image.PictureSize;

/** Whether a picture fits in what the JVM may still use. */
final class PictureMemory {
    private static final long MEGABYTE = 1 << 20;

    private PictureMemory() {}

    /** Throws before anything is allocated, rather than in the midst of it. */
    static void check(PictureSize size, long bytesPerPixel) {
        Runtime runtime = Runtime.getRuntime();
        long available = runtime.maxMemory() - (runtime.totalMemory() - runtime.freeMemory());
        long needed = size.pixels() * bytesPerPixel;
        if (needed > available) {
            throw new BadInputException("--size is " + size + ", which needs " + needed / MEGABYTE
                    + " MB of memory, but the JVM may use only " + available / MEGABYTE
                    + " MB more; ask for a smaller picture, or allow more with TWISTER_JAVA_OPTIONS=-Xmx"
                    + (needed / MEGABYTE + 1024) + "m");
        }
    }
}
