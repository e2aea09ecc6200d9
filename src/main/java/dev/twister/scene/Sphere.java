package dev.twister.scene;

/**
 * A sphere.
 *
 * @param position its center, in meters
 * @param radius in meters, above 0
 * @param color albedo
 * @param reflectivity p in [0, 128]: the Blinn-Phong exponent; p / 128 is the mirror ratio
 */
public record Sphere(Vector3 position, double radius, Rgb color, double reflectivity) {
    /** A matte white ball of radius 1 at the origin; has the values of the fields that {@link #of} leaves out. */
    static final Sphere DEFAULT = new Sphere(new Vector3(0, 0, 0), 1, new Rgb(1, 1, 1), 0);

    /** A sphere whose other properties are the defaults. */
    public static Sphere of(Vector3 position, double radius, Rgb color, double reflectivity) {
        return DEFAULT.withPosition(position)
                .withRadius(radius)
                .withColor(color)
                .withReflectivity(reflectivity);
    }

    public Sphere withPosition(Vector3 newPosition) {
        return new Sphere(newPosition, radius, color, reflectivity);
    }

    public Sphere withRadius(double newRadius) {
        return new Sphere(position, newRadius, color, reflectivity);
    }

    public Sphere withColor(Rgb newColor) {
        return new Sphere(position, radius, newColor, reflectivity);
    }

    public Sphere withReflectivity(double newReflectivity) {
        return new Sphere(position, radius, color, newReflectivity);
    }
}
