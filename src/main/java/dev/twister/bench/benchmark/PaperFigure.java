package dev.twister.bench.benchmark;

/** The figures of the paper's evaluation. */
public enum PaperFigure {
    SIZES("sizes", "Frames per second by picture size"),
    SHADOW_SAMPLES("shadow-samples", "Frames per second against shadow samples"),
    BOUNCES("bounces", "Frames per second against bounces"),
    SPEEDUP("speed-up", "Speed-up over the baselines");

    private final String id;
    private final String title;

    PaperFigure(String id, String title) {
        this.id = id;
        this.title = title;
    }

    /** The name in reports and file names. */
    public String id() {
        return id;
    }

    /** The name for display. */
    public String title() {
        return title;
    }
}
