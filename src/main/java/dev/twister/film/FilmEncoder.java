package dev.twister.film;

import java.io.IOException;

/**
 * Encodes a film frame by frame. The file takes its name in {@link #finish}; closed before that, no new file is left,
 * and an earlier one stays.
 */
interface FilmEncoder extends AutoCloseable {
    /**
     * Encodes the next frame.
     *
     * @param argb 0xAARRGGBB, sRGB-encoded, row by row from the top
     * @throws IOException the reason why the film cannot be written, on one line
     */
    void add(int[] argb) throws IOException;

    /**
     * Finishes the film after its last frame.
     *
     * @throws IOException as {@link #add}
     */
    void finish() throws IOException;

    @Override
    void close() throws IOException;
}
