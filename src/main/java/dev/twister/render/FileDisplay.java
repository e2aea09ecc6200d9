package dev.twister.render;

import dev.twister.image.DisplaySettings;
import dev.twister.image.Provenance;
import dev.twister.scene.Rendering;
import dev.twister.scene.ToneMap;
import dev.twister.world.FrameInput;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.Stream;

/** Exposure, tone map and transfer function of files of linear radiance. */
public final class FileDisplay {
    private FileDisplay() {}

    static DisplaySettings of(FrameInput input) {
        return new DisplaySettings(input.exposure(), name(input.toneMap()), input.srgb());
    }

    private static String name(ToneMap toneMap) {
        return toneMap.name().toLowerCase(Locale.ROOT);
    }

    /** The default settings with those of a file; what a file does not say, or says wrong, stays. */
    public static Rendering settings(Optional<Provenance> made) {
        return made.flatMap(Provenance::display)
                .map(display -> over(Rendering.DEFAULT, display))
                .orElse(Rendering.DEFAULT);
    }

    private static Rendering over(Rendering settings, DisplaySettings display) {
        boolean inRange = Math.abs(display.exposure()) <= Rendering.MAX_EXPOSURE_STOPS;
        return settings.withTone(
                inRange ? display.exposure() : settings.exposure(),
                Stream.of(ToneMap.values())
                        .filter(map -> name(map).equals(display.toneMap()))
                        .findFirst()
                        .orElse(settings.toneMap()),
                display.srgb());
    }
}
