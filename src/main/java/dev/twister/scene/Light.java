package dev.twister.scene;

/**
 * The one light: a sphere that is drawn in its own color, unshaded.
 *
 * @param position its center, in meters
 * @param radius in meters, above 0
 * @param color linear radiance
 */
public record Light(Vector3 position, double radius, Rgb color) {
    /** A white light of radius 1, 10 m above the origin. */
    public static final Light DEFAULT = new Light(new Vector3(0, 10, 0), 1, new Rgb(1, 1, 1));

    /** A light whose other properties are the defaults. */
    public static Light of(Vector3 position, double radius, Rgb color) {
        return DEFAULT.withPosition(position).withRadius(radius).withColor(color);
    }

    public Light withPosition(Vector3 newPosition) {
        return new Light(newPosition, radius, color);
    }

    public Light withRadius(double newRadius) {
        return new Light(position, newRadius, color);
    }

    public Light withColor(Rgb newColor) {
        return new Light(position, radius, newColor);
    }
}
