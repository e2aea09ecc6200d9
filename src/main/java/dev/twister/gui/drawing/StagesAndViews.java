package dev.twister.gui.drawing;

import dev.twister.world.StageOrView;
import java.util.List;
import java.util.Locale;

/** What the window can show of a scene: the stages up to the full picture, then the views. */
public final class StagesAndViews {
    private static final List<StageOrView> ALL = List.of(StageOrView.values());

    private StagesAndViews() {}

    /** In the order in which they are offered. */
    public static List<StageOrView> all() {
        return ALL;
    }

    /** The displayed name, such as {@code Hard shadows}. */
    public static String label(StageOrView picture) {
        String words = picture.stageId().replace('-', ' ');
        String label = words.substring(0, 1).toUpperCase(Locale.ROOT) + words.substring(1);
        return picture == StageOrView.BEAUTY ? label + " (full picture)" : label;
    }

    /** What it shows, in a few words. */
    public static String hint(StageOrView picture) {
        return switch (picture) {
            case COLORS -> "The base color of the closest hit.";
            case DIFFUSE -> "Shaded by the angle to the light, without shadows.";
            case HIGHLIGHTS -> "Diffuse shading with highlights.";
            case HARD_SHADOWS -> "One shadow ray per point, to the light's center.";
            case SOFT_SHADOWS -> "As many shadow rays per point as the scene has shadow samples.";
            case BEAUTY -> "The full picture, with reflections and refractions.";
            case ALBEDO -> "The color of the first hit, without light.";
            case NORMAL -> "The direction of the first hit's surface, as a color.";
            case DEPTH -> "Meters to the first hit; near is bright.";
            case BODY -> "A color for each body.";
            case SHADOW -> "The visible part of the light.";
            case BOUNCES -> "Reflected and refracted rays per pixel, as a heat map.";
            case TESTS -> "Intersection tests per pixel, as a heat map.";
        };
    }

    /** The value that many steps further, cyclically; backward if {@code steps} is negative. */
    public static StageOrView along(StageOrView picture, int steps) {
        return ALL.get(Math.floorMod(ALL.indexOf(picture) + steps, ALL.size()));
    }
}
