package dev.twister.cli.file;

import dev.twister.image.PictureSize;
import dev.twister.render.PictureMemory;

/** Whether a picture fits in the memory. */
public final class SizeCheck {
    private SizeCheck() {}

    /** Checks the size that {@code --size} gives. */
    public static void check(PictureSize size, long bytesPerPixel) {
        check("--size", size, bytesPerPixel);
    }

    /** Throws before anything is allocated, rather than in the midst of it. */
    public static void check(String name, PictureSize size, long bytesPerPixel) {
        PictureMemory.of(size, bytesPerPixel).ifPresent(shortage -> {
            throw new BadInputException(name + " " + shortage.text()
                    + "; ask for a smaller picture, or allow more with TWISTER_JAVA_OPTIONS=-Xmx"
                    + shortage.sufficientLimit() + "m");
        });
    }
}
