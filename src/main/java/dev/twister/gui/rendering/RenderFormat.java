package dev.twister.gui.rendering;

import java.util.Arrays;
import java.util.List;

/** The kinds of files that the window renders to. */
public enum RenderFormat {
    PNG("PNG", ".png", false),
    HDR("Radiance HDR, linear", ".hdr", false),
    EXR("OpenEXR, linear", ".exr", false),
    MP4("MP4, H.264", ".mp4", true),
    ANIMATED_PNG("Animated PNG", ".apng", true),
    PNG_FRAMES("PNG frames, numbered", ".png", true),
    EXR_FRAMES("OpenEXR frames, numbered", ".exr", true);

    private final String label;
    private final String ending;
    private final boolean film;

    RenderFormat(String label, String ending, boolean film) {
        this.label = label;
        this.ending = ending;
        this.film = film;
    }

    /**
     * Those of pictures, or of films.
     *
     * @param mp4 whether there is a program that makes MP4 films
     */
    public static List<RenderFormat> of(boolean film, boolean mp4) {
        return Arrays.stream(values())
                .filter(format -> format.film == film && (mp4 || format != MP4))
                .toList();
    }

    /** The displayed name. */
    public String label() {
        return label;
    }

    /** With its dot. */
    public String ending() {
        return ending;
    }

    /** Whether each frame is a file of its own. */
    public boolean isNumbered() {
        return this == PNG_FRAMES || this == EXR_FRAMES;
    }

    /** Whether a file has layers beside its colors. */
    public boolean hasLayers() {
        return this == EXR || this == EXR_FRAMES;
    }

    /** Whether a file has alpha, so that its pictures need no background. */
    public boolean hasAlpha() {
        return this != HDR && this != MP4;
    }

    /** The file name for a stem, with the number's placeholder if files are numbered. */
    public String fileName(String stem) {
        return stem + (isNumbered() ? "-####" : "") + ending;
    }
}
