package dev.twister.scene.material;

import java.nio.file.Path;

/**
 * An image that varies a property of a material over its surface.
 *
 * @param file already resolved against the scene file's folder
 * @param scale strength of a normal or occlusion map; other maps have 1
 */
public record ImageMap(Path file, Sampler sampler, double scale) {
    public static ImageMap of(Path file) {
        return new ImageMap(file, Sampler.DEFAULT, 1);
    }

    public ImageMap withScale(double newScale) {
        return new ImageMap(file, sampler, newScale);
    }
}
