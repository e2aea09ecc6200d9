package dev.twister.bench;

import dev.twister.image.PictureSize;

/** Hears how a benchmark comes along, as far as it cares. */
@SuppressWarnings("unused")
public interface BenchmarkProgress {
    BenchmarkProgress SILENT = new BenchmarkProgress() {};

    /** An engine starts on a size, with this number of frames at most; or its warm-up, with this number of steps. */
    default void begins(String engine, PictureSize size, int frames) {}

    /** A frame, warm-up or measured, is there; or a step of what comes before. */
    default void drewFrame() {}

    /** An engine is done with a setting, or failed; the report is unfinished and without pictures. */
    default void found(BenchmarkReport soFar) {}
}
