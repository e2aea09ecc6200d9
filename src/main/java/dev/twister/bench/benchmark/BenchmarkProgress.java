package dev.twister.bench.benchmark;

import dev.twister.image.PictureSize;

/** Receives the progress of a benchmark; all methods are optional. */
@SuppressWarnings("unused")
public interface BenchmarkProgress {
    BenchmarkProgress SILENT = new BenchmarkProgress() {};

    /**
     * An engine starts a setting, with at most this number of frames, or its preparation, with this number of steps.
     */
    default void begins(String engine, PictureSize size, int frames) {}

    /** A frame, warm-up or measured, or a step of preparation is complete. */
    default void drewFrame() {}

    /** An engine is not measured at a setting: a frame takes about this number of seconds, more than the limit. */
    default void leavesOut(String engine, Setting setting, double seconds) {}

    /** An engine has completed a setting or failed; the report is unfinished and has no pictures. */
    default void found(BenchmarkReport soFar) {}
}
