package dev.twister.bench.benchmark;

import dev.twister.bench.ReportNumbers;
import dev.twister.image.PictureSize;
import dev.twister.scene.Integrator;
import dev.twister.scene.Rendering;
import java.util.Optional;

/**
 * Size and shading of a measured picture.
 *
 * @param shadowSamples points on the light's disc; without effect if paths are traced
 * @param bounces limit of reflections
 * @param paths samples per pixel if paths are traced; empty for the integrator {@code whitted}, with the scene's own
 *     number of samples
 */
public record Setting(PictureSize size, int shadowSamples, int bounces, Optional<Integer> paths) {
    /** For the integrator {@code whitted}. */
    public Setting(PictureSize size, int shadowSamples, int bounces) {
        this(size, shadowSamples, bounces, Optional.empty());
    }

    public Rendering over(Rendering settings) {
        Rendering shaded = settings.withSize(size.width(), size.height())
                .withShadowSamples(shadowSamples)
                .withBounces(bounces);
        return paths.map(samples -> shaded.withIntegrator(Integrator.PATH).withSamplesPerPixel(samples))
                .orElseGet(() -> shaded.withIntegrator(Integrator.WHITTED));
    }

    /** How many paths are traced in a second at a rate; empty for the integrator {@code whitted}. */
    public Optional<Double> pathsPerSecond(double framesPerSecond) {
        return paths.map(samples -> framesPerSecond * samples * size.width() * size.height());
    }

    /** Samples and bounces as text. */
    public String shading() {
        return paths.map(samples -> "path tracing, " + ReportNumbers.counted(samples, "sample") + " per pixel")
                        .orElseGet(() -> ReportNumbers.counted(shadowSamples, "shadow sample"))
                + ", " + ReportNumbers.counted(bounces, "bounce");
    }

    @Override
    public String toString() {
        return size + ", " + shading();
    }
}
