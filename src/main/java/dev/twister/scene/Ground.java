package dev.twister.scene;

import static java.util.Objects.requireNonNull;

import dev.twister.scene.property.Copied;

/**
 * The checkered square ground, centered on the y axis.
 *
 * @param size the side of the square, in meters, above 0
 * @param height its y, in meters
 * @param oddColor albedo where {@code floor(x) + floor(z)} is odd
 * @param material its color is the albedo elsewhere
 */
@Copied
public record Ground(double size, double height, Rgb oddColor, Material material) implements GroundCopy.With {
    /** A matte square of 20 m at height 0, white and gray. */
    public static final Ground DEFAULT = new Ground(20, 0, new Rgb(0.5, 0.5, 0.5), Material.DEFAULT);

    public Ground {
        requireNonNull(oddColor, "oddColor");
        requireNonNull(material, "material");
    }

    /** A smooth, opaque plane; colors and reflectivity are {@link Material}'s. */
    public static Ground of(double size, double height, Rgb evenColor, Rgb oddColor, double reflectivity) {
        return DEFAULT.withSize(size)
                .withHeight(height)
                .withColors(evenColor, oddColor)
                .withReflectivity(reflectivity);
    }

    public Rgb evenColor() {
        return material.color();
    }

    public double reflectivity() {
        return material.reflectivity();
    }

    public Ground withColors(Rgb newEvenColor, Rgb newOddColor) {
        return new Ground(size, height, newOddColor, material.withColor(newEvenColor));
    }

    public Ground withReflectivity(double newReflectivity) {
        return withMaterial(material.withReflectivity(newReflectivity));
    }
}
