package dev.twister.scene;

/**
 * The checkered square ground, centered on the y axis.
 *
 * @param size the side of the square, in meters, above 0
 * @param height its y, in meters
 * @param evenColor albedo where {@code floor(x) + floor(z)} is even
 * @param oddColor albedo elsewhere
 * @param reflectivity p in [0, 128]: the Blinn-Phong exponent; p / 128 is the mirror ratio
 */
public record Plane(double size, double height, Rgb evenColor, Rgb oddColor, double reflectivity) {
    /** A matte square of 20 m at height 0, white and gray. */
    static final Plane DEFAULT = new Plane(20, 0, new Rgb(1, 1, 1), new Rgb(0.5, 0.5, 0.5), 0);

    /** A plane whose other properties are the defaults. */
    public static Plane of(double size, double height, Rgb evenColor, Rgb oddColor, double reflectivity) {
        return DEFAULT.withSize(size)
                .withHeight(height)
                .withColors(evenColor, oddColor)
                .withReflectivity(reflectivity);
    }

    public Plane withSize(double newSize) {
        return new Plane(newSize, height, evenColor, oddColor, reflectivity);
    }

    public Plane withHeight(double newHeight) {
        return new Plane(size, newHeight, evenColor, oddColor, reflectivity);
    }

    public Plane withColors(Rgb newEvenColor, Rgb newOddColor) {
        return new Plane(size, height, newEvenColor, newOddColor, reflectivity);
    }

    public Plane withReflectivity(double newReflectivity) {
        return new Plane(size, height, evenColor, oddColor, newReflectivity);
    }
}
