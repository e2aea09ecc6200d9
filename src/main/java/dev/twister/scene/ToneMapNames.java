package dev.twister.scene;

import java.util.Arrays;
import java.util.List;
import java.util.Locale;

/** The tone maps as a scene file names them, in the enum's order. */
final class ToneMapNames {
    static final List<String> ALL =
            Arrays.stream(ToneMap.values()).map(ToneMapNames::of).toList();

    private ToneMapNames() {}

    static String of(ToneMap toneMap) {
        return toneMap.name().toLowerCase(Locale.ROOT);
    }

    /** The tone map of a name in {@link #ALL}. */
    static ToneMap toneMap(String name) {
        return ToneMap.valueOf(name.toUpperCase(Locale.ROOT));
    }
}
