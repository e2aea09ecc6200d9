package dev.twister.bench;

/** Hears how a benchmark comes along. */
public interface BenchmarkProgress {
    /** For those who do not care. */
    BenchmarkProgress SILENT = new BenchmarkProgress() {
        @Override
        public void begins(String engine, PictureSize size, int frames) {}

        @Override
        public void drewFrame() {}
    };

    /** An engine starts on a size, with so many frames to come at most. */
    void begins(String engine, PictureSize size, int frames);

    /** A frame, warm-up or measured, is there. */
    void drewFrame();

    /** An engine is done with a size; not everyone minds. */
    default void measured(@SuppressWarnings("unused") Measurement measurement) {}
}
