package dev.twister.gui.model;

import dev.twister.engine.auto.FastestEngine;
import java.util.List;
import java.util.stream.Stream;

/**
 * What the window keeps from one run to the next.
 *
 * @param width of the window, in the screen's units, {@value #MIN_SIDE} to {@value #MAX_SIDE}
 * @param height as the width
 * @param maximized whether the window fills the screen
 * @param panelShown whether the panel is shown
 * @param frameTimesShown whether frames a second are shown over the picture
 * @param engine an engine's id
 * @param recentScenes scene files as absolute paths, the newest first, at most {@value #MAX_RECENT}
 * @param qUp whether Q leads up and E down, instead of the other way round
 * @param axisHandles whether bodies have arrows by which they are moved along an axis
 * @param folded headings of the panel whose sections are folded
 * @param hintSeen whether the hint of the first start has been seen
 */
public record WindowSettings(
        int width,
        int height,
        boolean maximized,
        boolean panelShown,
        boolean frameTimesShown,
        String engine,
        List<String> recentScenes,
        boolean qUp,
        boolean axisHandles,
        List<String> folded,
        boolean hintSeen) {
    public static final int MIN_SIDE = 200;
    public static final int MAX_SIDE = 16384;
    public static final int MAX_RECENT = 10;
    private static final int MAX_SECTIONS = 100;
    private static final int MAX_TEXT_LENGTH = 4096;

    public static final WindowSettings DEFAULT = new WindowSettings(
            1280,
            800,
            false,
            true,
            true,
            FastestEngine.AUTO,
            List.of(),
            false,
            true,
            List.of("Camera", "Views", "Light", "Sky", "Plane", "Physics", "Compare"),
            false);

    /**
     * Checks what may come from a file.
     *
     * @throws IllegalArgumentException where a value is out of range
     */
    public WindowSettings {
        require(width >= MIN_SIDE && width <= MAX_SIDE, "width");
        require(height >= MIN_SIDE && height <= MAX_SIDE, "height");
        require(engine != null && engine.length() <= MAX_TEXT_LENGTH, "engine");
        require(
                recentScenes != null
                        && recentScenes.size() <= MAX_RECENT
                        && recentScenes.stream().allMatch(file -> file != null && file.length() <= MAX_TEXT_LENGTH),
                "recentScenes");
        require(
                folded != null
                        && folded.size() <= MAX_SECTIONS
                        && folded.stream().allMatch(name -> name != null && name.length() <= MAX_TEXT_LENGTH),
                "folded");
        recentScenes = List.copyOf(recentScenes);
        folded = List.copyOf(folded);
    }

    public WindowSettings withWindow(int newWidth, int newHeight, boolean newMaximized) {
        return new WindowSettings(
                Math.clamp(newWidth, MIN_SIDE, MAX_SIDE),
                Math.clamp(newHeight, MIN_SIDE, MAX_SIDE),
                newMaximized,
                panelShown,
                frameTimesShown,
                engine,
                recentScenes,
                qUp,
                axisHandles,
                folded,
                hintSeen);
    }

    public WindowSettings withPanelShown(boolean shown) {
        return new WindowSettings(
                width,
                height,
                maximized,
                shown,
                frameTimesShown,
                engine,
                recentScenes,
                qUp,
                axisHandles,
                folded,
                hintSeen);
    }

    public WindowSettings withFrameTimesShown(boolean shown) {
        return new WindowSettings(
                width, height, maximized, panelShown, shown, engine, recentScenes, qUp, axisHandles, folded, hintSeen);
    }

    public WindowSettings withEngine(String id) {
        return new WindowSettings(
                width,
                height,
                maximized,
                panelShown,
                frameTimesShown,
                id,
                recentScenes,
                qUp,
                axisHandles,
                folded,
                hintSeen);
    }

    /** The file comes first; where there are too many, the oldest is forgotten. */
    public WindowSettings withRecentScene(String file) {
        List<String> newest = Stream.concat(Stream.of(file), recentScenes.stream())
                .distinct()
                .limit(MAX_RECENT)
                .toList();
        return new WindowSettings(
                width,
                height,
                maximized,
                panelShown,
                frameTimesShown,
                engine,
                newest,
                qUp,
                axisHandles,
                folded,
                hintSeen);
    }

    /** Without a file that is no longer there. */
    public WindowSettings withoutRecentScene(String file) {
        List<String> rest =
                recentScenes.stream().filter(recent -> !recent.equals(file)).toList();
        return new WindowSettings(
                width,
                height,
                maximized,
                panelShown,
                frameTimesShown,
                engine,
                rest,
                qUp,
                axisHandles,
                folded,
                hintSeen);
    }

    public WindowSettings withQUp(boolean up) {
        return new WindowSettings(
                width,
                height,
                maximized,
                panelShown,
                frameTimesShown,
                engine,
                recentScenes,
                up,
                axisHandles,
                folded,
                hintSeen);
    }

    public WindowSettings withAxisHandles(boolean shown) {
        return new WindowSettings(
                width,
                height,
                maximized,
                panelShown,
                frameTimesShown,
                engine,
                recentScenes,
                qUp,
                shown,
                folded,
                hintSeen);
    }

    /** With a section of the panel folded or not. */
    public WindowSettings withFolded(String heading, boolean isFolded) {
        List<String> others =
                folded.stream().filter(name -> !name.equals(heading)).toList();
        List<String> now =
                isFolded ? Stream.concat(others.stream(), Stream.of(heading)).toList() : others;
        return new WindowSettings(
                width,
                height,
                maximized,
                panelShown,
                frameTimesShown,
                engine,
                recentScenes,
                qUp,
                axisHandles,
                now,
                hintSeen);
    }

    public WindowSettings withHintSeen() {
        return new WindowSettings(
                width,
                height,
                maximized,
                panelShown,
                frameTimesShown,
                engine,
                recentScenes,
                qUp,
                axisHandles,
                folded,
                true);
    }

    private static void require(boolean holds, String field) {
        if (!holds) {
            throw new IllegalArgumentException(field + " is out of range");
        }
    }
}
