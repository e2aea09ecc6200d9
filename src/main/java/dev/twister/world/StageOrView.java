package dev.twister.world;

import dev.twister.kernel.Views;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;

/** The content of a frame: the full picture, one of its stages, or a view. {@link Views} defines the values. */
public enum StageOrView {
    /** First stage: the base color of the closest hit. */
    COLORS(Views.COLORS),
    /** Stage with shading by the angle to the light, without shadows and highlights. */
    DIFFUSE(Views.DIFFUSE),
    /** Stage with highlights. */
    HIGHLIGHTS(Views.HIGHLIGHTS),
    /** Stage with one shadow ray per surface, to the light's center. */
    HARD_SHADOWS(Views.FULL),
    /** Stage with the scene's number of shadow rays. */
    SOFT_SHADOWS(Views.FULL),
    /** The full picture: the last stage, with reflection and transmission, and the first view. */
    BEAUTY(Views.FULL),
    ALBEDO(Views.ALBEDO),
    NORMAL(Views.NORMAL),
    DEPTH(Views.DEPTH),
    BODY(Views.BODY),
    SHADOW(Views.SHADOW),
    BOUNCES(Views.BOUNCES),
    TESTS(Views.TESTS);

    private final int stageOrView;

    StageOrView(int stageOrView) {
        this.stageOrView = stageOrView;
    }

    /** A constant of {@link Views}. */
    public int stageOrView() {
        return stageOrView;
    }

    /** The stages in order; only the last one, the full picture, has reflections and refractions. */
    public static List<StageOrView> stages() {
        return Arrays.stream(values())
                .filter(shown -> shown.compareTo(BEAUTY) <= 0)
                .toList();
    }

    /** The full picture and the views. */
    public static List<StageOrView> views() {
        return Arrays.stream(values())
                .filter(shown -> shown.compareTo(BEAUTY) >= 0)
                .toList();
    }

    /** Whether values are colors, to which exposure and tone map apply; otherwise they are numbers or directions. */
    public boolean isColor() {
        return compareTo(ALBEDO) <= 0;
    }

    /** Whether values are single numbers, equal in all three channels. */
    public boolean isNumber() {
        return compareTo(DEPTH) >= 0;
    }

    /** The name among the stages; that of the full picture says what it adds. */
    public String stageId() {
        return this == BEAUTY ? "reflections" : id();
    }

    /** The name for commands, such as {@code hard-shadows}. */
    public String id() {
        return name().toLowerCase(Locale.ROOT).replace('_', '-');
    }

    public boolean bounces() {
        return compareTo(BEAUTY) >= 0;
    }
}
