package dev.twister.cli.option;

import dev.twister.scene.Scene;
import dev.twister.scene.Sky;
import dev.twister.scene.TrackTarget;
import dev.twister.scene.property.SceneProperties;
import java.nio.file.Path;
import java.util.Optional;
import picocli.CommandLine.Option;

/** What is behind everything, instead of the scene's own sky; within what a scene file may have. */
public final class SkyOptions {
    @Option(
            names = "--skybox",
            paramLabel = "FILE",
            description = "Panorama to use as the sky: .hdr, .exr, .png or .jpg.")
    private Optional<Path> skybox = Optional.empty();

    @Option(names = "--sky-rotation", paramLabel = "DEGREES", description = "Turn of the panorama to the right.")
    private Optional<Double> rotation = Optional.empty();

    @Option(
            names = "--sky-strength",
            paramLabel = "FACTOR",
            description = "Factor on the panorama's radiance, 0 or more.")
    private Optional<Double> strength = Optional.empty();

    public Scene over(Scene scene) {
        Sky own = scene.sky();
        Scene turned = rotation.isPresent() ? scene.withoutTrack(TrackTarget.SKY, "rotation") : scene;
        Scene fixed = strength.isPresent() ? turned.withoutTrack(TrackTarget.SKY, "strength") : turned;
        Sky sky = Ranges.over(
                own.withFile(skybox.orElse(own.file())), "--sky-rotation", rotation, SceneProperties.SKY_ROTATION);
        return fixed.withSky(Ranges.over(sky, "--sky-strength", strength, SceneProperties.SKY_STRENGTH));
    }
}
