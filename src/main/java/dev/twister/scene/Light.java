package dev.twister.scene;

import static java.util.Objects.requireNonNull;

import dev.twister.scene.light.LightGroup;
import dev.twister.scene.light.LightShape;
import dev.twister.scene.property.Copied;
import dev.twister.scene.select.Tag;
import java.util.Optional;

/**
 * A light: a sphere that is drawn in its own color, unshaded, or what its shape says.
 *
 * @param position its center, in meters; a sun has no place, and the default here
 * @param radius in meters, above 0; of a sun the default
 * @param color linear radiance
 * @param strength in m^2, for path tracing: the irradiance over pi, at one meter, of a surface that faces the light, is
 *     the color times this; without one the ground below the light is about as bright as without path tracing. Of a sun
 *     that irradiance is the same everywhere, and 1 without one
 * @param share factor, 0 or more, of what the light adds to the brightness of matte surfaces without path tracing
 * @param group name of the layer that its light goes to, see {@link LightGroup}
 */
@Copied
public record Light(
        Vector3 position,
        double radius,
        Rgb color,
        Optional<Double> strength,
        double share,
        String group,
        LightShape shape,
        Tag tag)
        implements LightCopy.With {
    /** A white light of radius 1, 10 m above the origin. */
    public static final Light DEFAULT = new Light(
            new Vector3(0, 10, 0),
            1,
            new Rgb(1, 1, 1),
            Optional.empty(),
            1,
            LightGroup.NONE,
            LightShape.SPHERE,
            Tag.NONE);

    public Light {
        requireNonNull(position, "position");
        requireNonNull(color, "color");
        requireNonNull(strength, "strength");
        requireNonNull(group, "group");
        requireNonNull(shape, "shape");
        requireNonNull(tag, "tag");
        if (shape.kind() == LightShape.Kind.SUN) {
            position = DEFAULT.position();
            radius = DEFAULT.radius();
        }
    }

    /** A light whose other properties are the defaults. */
    public static Light of(Vector3 position, double radius, Rgb color) {
        return DEFAULT.withPosition(position).withRadius(radius).withColor(color);
    }

    /** A white sun, whose other properties are the defaults. */
    public static Light sun(Vector3 direction, double angularDiameterDegrees) {
        return DEFAULT.withShape(
                LightShape.SUN.withDirection(direction).withAngularDiameterDegrees(angularDiameterDegrees));
    }

    /** A white spot, whose other properties are the defaults. */
    public static Light spot(Vector3 position, double radius, Vector3 direction, double coneAngleDegrees) {
        return DEFAULT.withPosition(position)
                .withRadius(radius)
                .withShape(LightShape.SPOT.withDirection(direction).withConeAngleDegrees(coneAngleDegrees));
    }

    /** Whether it is infinitely far away. */
    public boolean isSun() {
        return shape.kind() == LightShape.Kind.SUN;
    }

    public Light withStrength(double newStrength) {
        return withStrength(Optional.of(newStrength));
    }

    /** As bright in path tracing as without it. */
    public Light withoutStrength() {
        return withStrength(Optional.empty());
    }
}
