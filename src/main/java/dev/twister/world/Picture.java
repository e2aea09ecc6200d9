package dev.twister.world;

import dev.twister.kernel.Aspect;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;

/**
 * What a frame shows: the picture, one of the stages that lead to it, or a view. {@link Aspect} has what each value is.
 */
public enum Picture {
    /** Stages: the base color of the closest hit. */
    COLORS(Aspect.COLORS),
    /** Shaded by the angle to the light, without shadows and highlights. */
    DIFFUSE(Aspect.DIFFUSE),
    /** With highlights. */
    HIGHLIGHTS(Aspect.HIGHLIGHTS),
    /** With one shadow ray per surface, to the light's center. */
    HARD_SHADOWS(Aspect.FULL),
    /** With as many shadow rays as the scene has. */
    SOFT_SHADOWS(Aspect.FULL),
    /** With what mirrors and transparent bodies show: the picture itself. */
    REFLECTIONS(Aspect.FULL),
    /** Views: the picture itself, as compositors call it. */
    BEAUTY(Aspect.FULL),
    ALBEDO(Aspect.ALBEDO),
    NORMAL(Aspect.NORMAL),
    DEPTH(Aspect.DEPTH),
    BODY(Aspect.BODY),
    SHADOW(Aspect.SHADOW),
    BOUNCES(Aspect.BOUNCES),
    TESTS(Aspect.TESTS);

    private final int aspect;

    Picture(int aspect) {
        this.aspect = aspect;
    }

    /** One of {@link Aspect}'s numbers. */
    int aspect() {
        return aspect;
    }

    /** In the order in which the picture comes about; each but the last without reflections and refractions. */
    public static List<Picture> stages() {
        return Arrays.stream(values()).filter(Picture::isStage).toList();
    }

    public static List<Picture> views() {
        return Arrays.stream(values()).filter(picture -> !picture.isStage()).toList();
    }

    private boolean isStage() {
        return compareTo(REFLECTIONS) <= 0;
    }

    /** Whether it is light or a color, which exposure and tone map apply to; else it is a number or a direction. */
    public boolean isColor() {
        return isStage() || this == BEAUTY || this == ALBEDO;
    }

    /** Whether its values are single numbers, the same in all three channels. */
    public boolean isNumber() {
        return compareTo(DEPTH) >= 0;
    }

    /** The name that commands take, such as {@code hard-shadows}. */
    public String id() {
        return name().toLowerCase(Locale.ROOT).replace('_', '-');
    }

    boolean bounces() {
        return !isStage() || this == REFLECTIONS;
    }
}
