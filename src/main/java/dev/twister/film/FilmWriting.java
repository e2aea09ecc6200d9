package dev.twister.film;

import dev.twister.threads.BackgroundWriter;
import java.io.IOException;

/** Encodes a film in the background while the next frames are rendered. */
public final class FilmWriting implements AutoCloseable {
    /** Number of frames in memory that are not encoded yet. */
    public static final int WAITING = 3;

    private final FilmEncoder encoder;
    private final BackgroundWriter writer = new BackgroundWriter("encoding", 1, WAITING);

    /**
     * Begins a film.
     *
     * @throws IOException if the file cannot be written
     */
    public FilmWriting(FilmFile film, FilmFormat format) throws IOException {
        encoder = film.begin(format);
    }

    /**
     * Hands over the next frame; waits while too many are waiting.
     *
     * @param argb 0xAARRGGBB, sRGB-encoded, row by row from the top; not to be changed afterwards
     * @throws IOException the failure of the encoder
     */
    public void add(int[] argb) throws IOException {
        writer.submit(1, () -> encoder.add(argb));
    }

    /**
     * Waits until the film is written.
     *
     * @throws IOException the failure of the encoder
     */
    public void finish() throws IOException {
        writer.finish();
        encoder.finish();
    }

    /** Without {@link #finish} before, no new film is left. */
    @Override
    public void close() throws IOException {
        writer.close();
        encoder.close();
    }
}
