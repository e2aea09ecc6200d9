package dev.twister.cli;

import dev.twister.scene.RenderSettings;
import dev.twister.scene.ToneMap;
import java.util.Optional;
import picocli.CommandLine.Option;

/** How linear color becomes a pixel. */
final class ToneOptions {
    @Option(
            names = "--exposure",
            paramLabel = "STOPS",
            description = "Multiply the brightness by 2^STOPS, -20 to 20. .hdr and .exr files keep the radiance.")
    private Optional<Double> exposure = Optional.empty();

    @Option(
            names = "--tone-map",
            paramLabel = "NAME",
            completionCandidates = Completions.OfToneMap.class,
            description = "clamp, reinhard or aces.")
    private Optional<ToneMap> toneMap = Optional.empty();

    @Option(names = "--srgb", negatable = true, description = "Apply the sRGB transfer function after tone mapping.")
    private Optional<Boolean> srgb = Optional.empty();

    RenderSettings over(RenderSettings settings) {
        double stops = Ranges.check(
                "--exposure",
                exposure.orElse(settings.exposure()),
                -RenderSettings.MAX_EXPOSURE_STOPS,
                RenderSettings.MAX_EXPOSURE_STOPS);
        return settings.withTone(stops, toneMap.orElse(settings.toneMap()), srgb.orElse(settings.srgb()));
    }
}
