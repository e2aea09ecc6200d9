package dev.twister.scene;

import static java.util.Objects.requireNonNull;

/**
 * The checkered square ground, centered on the y axis.
 *
 * @param size the side of the square, in meters, above 0
 * @param height its y, in meters
 * @param oddColor albedo where {@code floor(x) + floor(z)} is odd
 * @param material its color is the albedo elsewhere
 */
public record Ground(double size, double height, Rgb oddColor, Material material) {
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

    public Ground withSize(double newSize) {
        return new Ground(newSize, height, oddColor, material);
    }

    public Ground withHeight(double newHeight) {
        return new Ground(size, newHeight, oddColor, material);
    }

    public Ground withMaterial(Material newMaterial) {
        return new Ground(size, height, oddColor, newMaterial);
    }

    public Ground withColors(Rgb newEvenColor, Rgb newOddColor) {
        return new Ground(size, height, newOddColor, material.withColor(newEvenColor));
    }

    public Ground withOddColor(Rgb newOddColor) {
        return new Ground(size, height, newOddColor, material);
    }

    public Ground withReflectivity(double newReflectivity) {
        return withMaterial(material.withReflectivity(newReflectivity));
    }
}
