package dev.twister.render;

import java.util.stream.IntStream;

/**
 * Frames of a film.
 *
 * @param first the number of the first one
 * @param last the number of the last one, at least the first's
 * @param counted whether only their number was given: then they are the whole film
 */
public record FrameRange(int first, int last, boolean counted) {
    /** More are not numbered. */
    public static final int MOST = 1_000_000;

    /** As many frames, from 0 on. */
    public static FrameRange ofCount(int count) {
        return new FrameRange(0, count - 1, true);
    }

    /** Both are in it. */
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
