package dev.twister.cli.option;

import dev.twister.cli.file.BadInputException;
import dev.twister.cli.option.ExposureConverter.Exposure;
import dev.twister.scene.Rendering;
import dev.twister.scene.Scene;
import dev.twister.scene.ToneMap;
import dev.twister.scene.TrackTarget;
import dev.twister.scene.property.SceneProperties;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.function.Supplier;
import picocli.CommandLine.Option;

/** How linear color becomes a pixel. */
public final class ToneOptions {
    @Option(
            names = "--exposure",
            paramLabel = "STOPS",
            converter = ExposureConverter.class,
            completionCandidates = Completions.OfExposure.class,
            description = "Multiply the brightness by 2^STOPS, -20 to 20; auto sets it by the picture, or by a film's"
                    + " first frame. .hdr and .exr files keep the radiance.")
    private Optional<Exposure> exposure = Optional.empty();

    @Option(names = "--tone-map", paramLabel = "MAP", description = "clamp, reinhard or aces.")
    private Optional<ToneMap> toneMap = Optional.empty();

    @Option(names = "--srgb", negatable = true, description = "Apply the sRGB transfer function after tone mapping.")
    private Optional<Boolean> srgb = Optional.empty();

    /** An exposure of auto is left as it is, for {@link #metered}. */
    public Rendering over(Rendering settings) {
        Optional<Double> stops =
                exposure.flatMap(given -> given.stops().stream().boxed().findFirst());
        Rendering toned = Ranges.over(settings, "--exposure", stops, SceneProperties.EXPOSURE);
        toned = Ranges.over(toned, "--tone-map", toneMap, SceneProperties.TONE_MAP);
        return Ranges.over(toned, "--srgb", srgb, SceneProperties.SRGB);
    }

    /** The scene without the track of the exposure, if the options say it. */
    public Scene fixed(Scene scene) {
        return exposure.isPresent() ? scene.withoutTrack(TrackTarget.RENDERING, "exposure") : scene;
    }

    /** Whether the picture is to tell the exposure. */
    public boolean isMetered() {
        return exposure.filter(given -> given.stops().isEmpty()).isPresent();
    }

    /**
     * With the exposure that was measured, where that was asked for.
     *
     * @param stops empty where there is no light in the picture
     */
    public Rendering metered(Rendering settings, Supplier<OptionalDouble> stops) {
        if (!isMetered()) {
            return settings;
        }
        return settings.withExposure(stops.get()
                .orElseThrow(() ->
                        new BadInputException("--exposure is auto, but the picture is black; give a number of stops")));
    }
}
