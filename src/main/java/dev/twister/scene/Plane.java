package dev.twister.scene;

/**
 * The checkered square ground, centred on the y axis.
 *
 * @param size the side of the square, in metres, above 0
 * @param height its y, in metres
 * @param evenColor albedo where {@code floor(x) + floor(z)} is even
 * @param oddColor albedo elsewhere
 * @param reflectivity p in [0, 128]: the Blinn-Phong exponent; p / 128 is the mirror ratio
 */
public record Plane(double size, double height, Rgb evenColor, Rgb oddColor, double reflectivity) {}
