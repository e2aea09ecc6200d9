package dev.twister.scene;

import static java.util.Objects.requireNonNull;

import dev.twister.scene.property.Copied;
import java.nio.file.Path;

/**
 * What surrounds a scene.
 *
 * @param file the panorama, already resolved against the scene file's folder, or {@link #PLAIN}
 * @param rotationDegrees how far the panorama is turned to the right, about the y axis
 * @param strength what its radiance is multiplied by, 0 or more
 */
@Copied
public record Sky(Path file, double rotationDegrees, double strength) implements SkyCopy.With {
    /** Of a file's name: no panorama, but light gray all around. */
    public static final Path PLAIN = Path.of("");

    public Sky {
        requireNonNull(file, "file");
    }

    public static Sky of(Path file) {
        return new Sky(file, 0, 1);
    }
}
