package dev.twister.scene;

import java.util.Arrays;
import java.util.List;
import java.util.Locale;

/** The palettes as a scene file names them, in the enum's order. */
final class PaletteNames {
    static final List<String> ALL =
            Arrays.stream(Palette.values()).map(PaletteNames::of).toList();

    private PaletteNames() {}

    static String of(Palette palette) {
        return palette.name().toLowerCase(Locale.ROOT);
    }

    /** The palette of a name in {@link #ALL}. */
    static Palette palette(String name) {
        return Palette.valueOf(name.toUpperCase(Locale.ROOT));
    }
}
