package dev.twister.scene;

/**
 * A sphere.
 *
 * @param position its centre, in metres
 * @param radius in metres, above 0
 * @param color albedo
 * @param reflectivity p in [0, 128]: the Blinn-Phong exponent; p / 128 is the mirror ratio
 */
public record Sphere(Vector3 position, double radius, Rgb color, double reflectivity) {}
