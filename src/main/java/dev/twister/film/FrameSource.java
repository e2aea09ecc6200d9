package dev.twister.film;

import java.io.IOException;

/** Gives a film's frames one after the other. */
@FunctionalInterface
public interface FrameSource {
    /** The next frame: sRGB-encoded pixels, 0xAARRGGBB, row by row from the top; alpha is ignored. */
    int[] next() throws IOException;
}
