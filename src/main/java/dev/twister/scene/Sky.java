package dev.twister.scene;

import static java.util.Objects.requireNonNull;

import java.nio.file.Path;

/**
 * What surrounds a scene.
 *
 * @param file the panorama, already resolved against the scene file's folder
 * @param rotationDegrees how far the panorama is turned to the right, about the y axis
 * @param strength what its radiance is multiplied by, 0 or more
 */
public record Sky(Path file, double rotationDegrees, double strength) {
    public Sky {
        requireNonNull(file, "file");
    }

    public static Sky of(Path file) {
        return new Sky(file, 0, 1);
    }

    public Sky withFile(Path newFile) {
        return new Sky(newFile, rotationDegrees, strength);
    }

    public Sky withRotationDegrees(double newRotationDegrees) {
        return new Sky(file, newRotationDegrees, strength);
    }

    public Sky withStrength(double newStrength) {
        return new Sky(file, rotationDegrees, newStrength);
    }
}
