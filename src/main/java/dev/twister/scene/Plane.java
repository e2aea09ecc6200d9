package dev.twister.scene;

/**
 * The checkered square ground, centered on the y axis.
 *
 * @param size the side of the square, in meters, above 0
 * @param height its y, in meters
 * @param oddColor albedo where {@code floor(x) + floor(z)} is odd
 * @param material its color is the albedo elsewhere
 */
public record Plane(double size, double height, Rgb oddColor, Material material) {
    /** A matte square of 20 m at height 0, white and gray. */
    public static final Plane DEFAULT = new Plane(20, 0, new Rgb(0.5, 0.5, 0.5), Material.DEFAULT);

    /** A smooth, opaque plane; colors and reflectivity are {@link Material}'s. */
    public static Plane of(double size, double height, Rgb evenColor, Rgb oddColor, double reflectivity) {
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

    public Plane withSize(double newSize) {
        return new Plane(newSize, height, oddColor, material);
    }

    public Plane withHeight(double newHeight) {
        return new Plane(size, newHeight, oddColor, material);
    }

    public Plane withMaterial(Material newMaterial) {
        return new Plane(size, height, oddColor, newMaterial);
    }

    public Plane withColors(Rgb newEvenColor, Rgb newOddColor) {
        return new Plane(size, height, newOddColor, material.withColor(newEvenColor));
    }

    public Plane withOddColor(Rgb newOddColor) {
        return new Plane(size, height, newOddColor, material);
    }

    public Plane withReflectivity(double newReflectivity) {
        return withMaterial(material.withReflectivity(newReflectivity));
    }
}
