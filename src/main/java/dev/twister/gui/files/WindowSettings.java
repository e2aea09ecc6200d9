package dev.twister.gui.files;

import dev.twister.engine.auto.FastestEngine;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.SequencedMap;
import java.util.function.Function;
import java.util.stream.Stream;

/**
 * The settings that the window keeps from one run to the next.
 *
 * @param values by the names of the keys; missing ones have their defaults, those of unknown names are dropped
 */
public record WindowSettings(Map<String, Object> values) {
    public static final int MIN_SIDE = 200;
    public static final int MAX_SIDE = 16384;
    public static final int MAX_RECENT = 10;
    private static final int MAX_SECTIONS = 100;
    private static final int MAX_TEXT_LENGTH = 4096;

    /**
     * One setting.
     *
     * @param name in the settings file
     * @param usual the default
     * @param read checks a value from the file; empty if it is out of range or of another type
     */
    public record Key<T>(String name, T usual, Function<Object, Optional<T>> read) {
        private T checked(Object value) {
            return read.apply(value).orElseThrow(() -> new IllegalArgumentException(name + " is out of range"));
        }
    }

    /** Of the window, in the screen's units. */
    public static final Key<Integer> WIDTH = side("width", 1280);

    public static final Key<Integer> HEIGHT = side("height", 800);
    public static final Key<Boolean> MAXIMIZED = flag("maximized", false);
    public static final Key<Boolean> PANEL_SHOWN = flag("panelShown", true);
    public static final Key<Boolean> FRAME_TIMES_SHOWN = flag("frameTimesShown", false);

    /** The id of an engine. */
    public static final Key<String> ENGINE = new Key<>("engine", FastestEngine.AUTO, WindowSettings::text);

    /** Scene files as absolute paths, the newest first. */
    public static final Key<List<String>> RECENT_SCENES = texts("recentScenes", MAX_RECENT, List.of());

    /** Whether Q moves the camera up and E down, instead of the other way round. */
    public static final Key<Boolean> Q_UP = flag("qUp", false);

    /** The panel's width where none was dragged: that of the style sheet, by the text's size. */
    public static final int USUAL_PANEL = 0;

    /** Of the panel, in the screen's units. */
    public static final Key<Integer> PANEL_WIDTH = number("panelWidth", USUAL_PANEL, USUAL_PANEL);

    /** Whether the panel is in a window of its own. */
    public static final Key<Boolean> PANEL_FLOATS = flag("panelFloats", false);

    /** Where that window is on the screen, see {@link Bounds}. */
    static final Key<Integer> PANEL_X = number("panelX", 0, -MAX_SIDE);

    static final Key<Integer> PANEL_Y = number("panelY", 0, -MAX_SIDE);
    static final Key<Integer> PANEL_WINDOW_WIDTH = number("panelWindowWidth", 0, 0);
    static final Key<Integer> PANEL_WINDOW_HEIGHT = number("panelWindowHeight", 0, 0);

    /** Whether selected bodies have arrows that move them along an axis. */
    public static final Key<Boolean> AXIS_HANDLES = flag("axisHandles", true);

    /** Headings of the panel's folded sections. */
    public static final Key<List<String>> FOLDED =
            texts("folded", MAX_SECTIONS, List.of("Camera", "Views", "Light", "Sky", "Plane", "Physics", "Compare"));

    /** Whether path-traced pictures are shown without their noise. */
    public static final Key<Boolean> DENOISED = flag("denoised", true);

    /** Whether the hint of the first start has been seen. */
    public static final Key<Boolean> HINT_SEEN = flag("hintSeen", false);

    private static final List<Key<?>> KEYS = List.of(
            WIDTH,
            HEIGHT,
            MAXIMIZED,
            PANEL_SHOWN,
            FRAME_TIMES_SHOWN,
            ENGINE,
            RECENT_SCENES,
            Q_UP,
            PANEL_WIDTH,
            PANEL_FLOATS,
            PANEL_X,
            PANEL_Y,
            PANEL_WINDOW_WIDTH,
            PANEL_WINDOW_HEIGHT,
            AXIS_HANDLES,
            FOLDED,
            DENOISED,
            HINT_SEEN);

    public static final WindowSettings DEFAULT = new WindowSettings(Map.of());

    /**
     * Checks the values, which may come from a file.
     *
     * @throws IllegalArgumentException if one is out of range
     */
    public WindowSettings {
        SequencedMap<String, Object> known = new LinkedHashMap<>();
        for (Key<?> key : KEYS) {
            known.put(key.name(), key.checked(values.getOrDefault(key.name(), key.usual())));
        }
        values = Collections.unmodifiableMap(known);
    }

    public <T> T get(Key<T> key) {
        return key.checked(values.get(key.name()));
    }

    public <T> WindowSettings with(Key<T> key, T value) {
        Map<String, Object> changed = new LinkedHashMap<>(values);
        changed.put(key.name(), value);
        return new WindowSettings(changed);
    }

    /** With the window's size, clamped to what is allowed. */
    public WindowSettings withSize(int width, int height) {
        return with(WIDTH, Math.clamp(width, MIN_SIDE, MAX_SIDE)).with(HEIGHT, Math.clamp(height, MIN_SIDE, MAX_SIDE));
    }

    /** With a file as the newest; the oldest is dropped if there are too many. */
    public WindowSettings withRecentScene(String file) {
        return with(
                RECENT_SCENES,
                Stream.concat(Stream.of(file), get(RECENT_SCENES).stream())
                        .distinct()
                        .limit(MAX_RECENT)
                        .toList());
    }

    /** Without a file that no longer exists. */
    public WindowSettings withoutRecentScene(String file) {
        return with(RECENT_SCENES, without(get(RECENT_SCENES), file));
    }

    /** With a section of the panel folded or not. */
    public WindowSettings withFolded(String heading, boolean isFolded) {
        List<String> others = without(get(FOLDED), heading);
        return with(
                FOLDED,
                isFolded ? Stream.concat(others.stream(), Stream.of(heading)).toList() : others);
    }

    private static List<String> without(List<String> texts, String text) {
        return texts.stream().filter(other -> !other.equals(text)).toList();
    }

    private static Key<Integer> side(String name, int usual) {
        return number(name, usual, MIN_SIDE);
    }

    private static Key<Integer> number(String name, int usual, int least) {
        return new Key<>(
                name,
                usual,
                value -> value instanceof Integer number && number >= least && number <= MAX_SIDE
                        ? Optional.of(number)
                        : Optional.empty());
    }

    private static Key<Boolean> flag(String name, boolean usual) {
        return new Key<>(name, usual, value -> value instanceof Boolean on ? Optional.of(on) : Optional.empty());
    }

    private static Key<List<String>> texts(String name, int most, List<String> usual) {
        return new Key<>(name, usual, value -> {
            if (!(value instanceof List<?> list) || list.size() > most) {
                return Optional.empty();
            }
            List<String> texts =
                    list.stream().flatMap(text -> text(text).stream()).toList();
            return Optional.of(texts).filter(_ -> texts.size() == list.size());
        });
    }

    private static Optional<String> text(Object value) {
        return value instanceof String text && text.length() <= MAX_TEXT_LENGTH ? Optional.of(text) : Optional.empty();
    }

    /** Where a window is on the screen, and how large, in the screen's units. */
    public record Bounds(double x, double y, double width, double height) {
        /** Of the panel's window; empty if it never was anywhere. */
        public static Optional<Bounds> of(WindowSettings settings) {
            int width = settings.get(WindowSettings.PANEL_WINDOW_WIDTH);
            int height = settings.get(WindowSettings.PANEL_WINDOW_HEIGHT);
            return Optional.of(new Bounds(
                            settings.get(WindowSettings.PANEL_X), settings.get(WindowSettings.PANEL_Y), width, height))
                    .filter(_ -> width > 0 && height > 0);
        }

        /** The settings with this as the place of the panel's window. */
        public WindowSettings keptIn(WindowSettings settings) {
            return settings.with(WindowSettings.PANEL_X, clamped(x, -WindowSettings.MAX_SIDE))
                    .with(WindowSettings.PANEL_Y, clamped(y, -WindowSettings.MAX_SIDE))
                    .with(WindowSettings.PANEL_WINDOW_WIDTH, clamped(width, 0))
                    .with(WindowSettings.PANEL_WINDOW_HEIGHT, clamped(height, 0));
        }

        private static int clamped(double number, int least) {
            return (int) Math.clamp(Math.rint(number), least, WindowSettings.MAX_SIDE);
        }
    }
}
