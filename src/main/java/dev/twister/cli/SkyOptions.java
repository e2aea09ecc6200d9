package dev.twister.cli;

import dev.twister.scene.Scene;
import dev.twister.scene.SceneLimits;
import java.nio.file.Path;
import java.util.Optional;
import picocli.CommandLine.Option;

/** What is behind everything, instead of the scene's own sky; within what a scene file may have. */
final class SkyOptions {
    @Option(names = "--skybox", paramLabel = "FILE", description = "Panorama to use as the sky: .hdr, .png or .jpg.")
    private Optional<Path> skybox = Optional.empty();

    @Option(names = "--sky-rotation", paramLabel = "DEGREES", description = "Turn of the panorama to the right.")
    private Optional<Double> rotation = Optional.empty();

    @Option(
            names = "--sky-strength",
            paramLabel = "FACTOR",
            description = "Factor on the panorama's radiance, 0 or more.")
    private Optional<Double> strength = Optional.empty();

    Scene over(Scene scene) {
        return scene.withSkybox(skybox.orElse(scene.skybox()))
                .withSkyRotation(Ranges.check(
                        "--sky-rotation", rotation.orElse(scene.skyRotationDegrees()), SceneLimits.SKY_ROTATION))
                .withSkyStrength(
                        Ranges.check("--sky-strength", strength.orElse(scene.skyStrength()), SceneLimits.SKY_STRENGTH));
    }
}
