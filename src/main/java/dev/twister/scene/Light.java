package dev.twister.scene;

/**
 * The one light: a sphere that is drawn in its own colour, unshaded.
 *
 * @param position its centre, in metres
 * @param radius in metres, above 0
 * @param color linear radiance
 */
public record Light(Vector3 position, double radius, Rgb color) {}
