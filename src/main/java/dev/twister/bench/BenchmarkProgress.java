package dev.twister.bench;

import dev.twister.image.PictureSize;

/** Hears how a benchmark comes along. */
public interface BenchmarkProgress {
    /** For those who do not care. */
    BenchmarkProgress SILENT = new BenchmarkProgress() {
        @Override
        public void begins(String engine, PictureSize size, int frames) {}

        @Override
        public void drewFrame() {}
    };

    /** An engine starts on a size, with so many frames to come at most; or what comes before them, with so many steps. */
    void begins(String engine, PictureSize size, int frames);

    /** A frame, warm-up or measured, is there; or a step of what comes before. */
    void drewFrame();

    /** An engine is done with a setting, or failed; the report is unfinished and without pictures. */
    default void found(@SuppressWarnings("unused") BenchmarkReport soFar) {}
}
