package dev.twister.mesh;

import dev.twister.scene.Rgb;
import dev.twister.scene.Vector3;

/**
 * A light of a file, without a size.
 *
 * @param kind how far away it is
 * @param color linear
 * @param intensity in candela, or in lux if the light is far away
 * @param position in meters; without meaning if the light is far away
 * @param direction unit vector in which it shines; without meaning if the light is near
 */
public record FileLight(Kind kind, Rgb color, double intensity, Vector3 position, Vector3 direction) {
    /** How far away a light is. */
    public enum Kind {
        NEAR,
        FAR
    }

    FileLight placed(Affine placement) {
        return new FileLight(
                kind,
                color,
                intensity,
                placement.point(position),
                placement.direction(direction).normalized());
    }
}
