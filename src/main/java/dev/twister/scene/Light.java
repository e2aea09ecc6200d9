package dev.twister.scene;

import static java.util.Objects.requireNonNull;

import dev.twister.scene.light.LightGroup;
import dev.twister.scene.property.Copied;
import dev.twister.scene.select.Tag;
import java.util.Optional;

/**
 * A light: a sphere that is drawn in its own color, unshaded.
 *
 * @param position its center, in meters
 * @param radius in meters, above 0
 * @param color linear radiance
 * @param strength in m^2, for path tracing: the irradiance over pi, at one meter, of a surface that faces the light, is
 *     the color times this; without one the ground below the light is about as bright as without path tracing
 * @param share factor, 0 or more, of what the light adds to the brightness of matte surfaces without path tracing
 * @param group name of the layer that its light goes to, see {@link LightGroup}
 */
@Copied
public record Light(
        Vector3 position, double radius, Rgb color, Optional<Double> strength, double share, String group, Tag tag)
        implements LightCopy.With {
    /** A white light of radius 1, 10 m above the origin. */
    public static final Light DEFAULT =
            new Light(new Vector3(0, 10, 0), 1, new Rgb(1, 1, 1), Optional.empty(), 1, LightGroup.NONE, Tag.NONE);

    public Light {
        requireNonNull(position, "position");
        requireNonNull(color, "color");
        requireNonNull(strength, "strength");
        requireNonNull(group, "group");
        requireNonNull(tag, "tag");
    }

    /** A light whose other properties are the defaults. */
    public static Light of(Vector3 position, double radius, Rgb color) {
        return DEFAULT.withPosition(position).withRadius(radius).withColor(color);
    }

    public Light withStrength(double newStrength) {
        return withStrength(Optional.of(newStrength));
    }

    /** As bright in path tracing as without it. */
    public Light withoutStrength() {
        return withStrength(Optional.empty());
    }
}
