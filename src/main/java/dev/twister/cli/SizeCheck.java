package dev.twister.cli;

import dev.twister.image.PictureSize;
import dev.twister.render.PictureMemory;

/** Whether a picture of the size that {@code --size} gives fits in the memory. */
final class SizeCheck {
    private static final int SPARE_MEGABYTES = 1024;

    private SizeCheck() {}

    /** Throws before anything is allocated, rather than in the midst of it. */
    static void check(PictureSize size, long bytesPerPixel) {
        PictureMemory.of(size, bytesPerPixel).ifPresent(shortage -> {
            throw new BadInputException("--size " + shortage.text()
                    + "; ask for a smaller picture, or allow more with TWISTER_JAVA_OPTIONS=-Xmx"
                    + (shortage.needed() + SPARE_MEGABYTES) + "m");
        });
    }
}
