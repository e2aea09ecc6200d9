package dev.twister.bench;

/** What the paper's evaluation shows. */
public enum PaperFigure {
    SIZES("sizes", "Frames a second by picture size"),
    SHADOW_SAMPLES("shadow-samples", "Frames a second against shadow samples"),
    BOUNCES("bounces", "Frames a second against bounces"),
    SPEEDUP("speed-up", "Speed-up over the baselines");

    private final String id;
    private final String title;

    PaperFigure(String id, String title) {
        this.id = id;
        this.title = title;
    }

    /** Its name in the reports and in files' names. */
    public String id() {
        return id;
    }

    /** Its name for a person. */
    public String title() {
        return title;
    }
}
