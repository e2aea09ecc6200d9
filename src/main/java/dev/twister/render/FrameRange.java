package dev.twister.render;

import java.util.stream.IntStream;

/**
 * Frames of a film.
 *
 * @param first number of the first frame
 * @param last number of the last frame, at least {@code first}
 * @param counted whether only a count was given; then the range is the whole film
 */
public record FrameRange(int first, int last, boolean counted) {
    /** Largest number of frames. */
    public static final int MOST = 1_000_000;

    /** This number of frames, starting with 0. */
    public static FrameRange ofCount(int count) {
        return new FrameRange(0, count - 1, true);
    }

    /** The frames from {@code first} to {@code last}, both included. */
    public static FrameRange of(int first, int last) {
        return new FrameRange(first, last, false);
    }

    public int count() {
        return last - first + 1;
    }

    public IntStream numbers() {
        return IntStream.rangeClosed(first, last);
    }
}
