package dev.twister.cli;

import dev.twister.scene.Rendering;
import java.util.Optional;
import picocli.CommandLine.Option;

/** What costs time in a picture. */
final class ShadingOptions {
    @Option(
            names = "--shadow-samples",
            paramLabel = "N",
            description = "Points on the light's disc, 1 to " + Rendering.MAX_SHADOW_SAMPLES + "; 1 is a hard shadow.")
    private Optional<Integer> shadowSamples = Optional.empty();

    @Option(
            names = "--bounces",
            paramLabel = "N",
            description = "Most reflections per ray, 0 to " + Rendering.MAX_BOUNCES + ".")
    private Optional<Integer> bounces = Optional.empty();

    int shadowSamplesOr(int usual) {
        return Ranges.check("--shadow-samples", shadowSamples.orElse(usual), 1, Rendering.MAX_SHADOW_SAMPLES);
    }

    int bouncesOr(int usual) {
        return Ranges.check("--bounces", bounces.orElse(usual), 0, Rendering.MAX_BOUNCES);
    }

    boolean areGiven() {
        return shadowSamples.isPresent() || bounces.isPresent();
    }
}
