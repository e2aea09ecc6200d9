package dev.twister.cli.option;

import dev.twister.scene.Integrator;
import dev.twister.scene.Rendering;
import dev.twister.scene.property.SceneProperties;
import java.util.Optional;
import picocli.CommandLine.Option;

/** What costs time in a picture. */
public final class ShadingOptions {
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

    @Option(
            names = "--integrator",
            paramLabel = "INTEGRATOR",
            description = "How light is followed: whitted (reflections and shadows) or path (path tracing).")
    private Optional<Integrator> integrator = Optional.empty();

    @Option(
            names = "--clamp",
            paramLabel = "X",
            description =
                    "Path tracing: limit of the luminance of light that reaches the eye over more than one surface;"
                            + " 0 for none. Lower values remove bright specks and lose some light.")
    private Optional<Double> clamp = Optional.empty();

    /** The settings with what the options say. */
    public Rendering over(Rendering usual) {
        Rendering shaded = Ranges.over(usual, "--shadow-samples", shadowSamples, SceneProperties.SHADOW_SAMPLES);
        shaded = Ranges.over(shaded, "--bounces", bounces, SceneProperties.BOUNCES);
        shaded = Ranges.over(shaded, "--integrator", integrator, SceneProperties.INTEGRATOR);
        return Ranges.over(shaded, "--clamp", clamp, SceneProperties.CLAMP);
    }

    public boolean areGiven() {
        return shadowSamples.isPresent() || bounces.isPresent() || integrator.isPresent() || clamp.isPresent();
    }
}
