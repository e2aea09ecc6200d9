package dev.twister.scene.light;

import static java.util.Objects.requireNonNull;

import dev.twister.scene.Vector3;
import dev.twister.scene.property.Copied;
import java.util.Locale;

/**
 * What a light is, and where it shines.
 *
 * @param direction in which the light shines, of any length above 0; a sphere shines in all
 * @param angularDiameterDegrees of a sun's disc, from 0 for a sharp one
 */
@Copied
public record LightShape(Kind kind, Vector3 direction, double angularDiameterDegrees) implements LightShapeCopy.With {
    /** What gives the light. */
    public enum Kind {
        /** A sphere of some radius at a place. */
        SPHERE,
        /** A disc infinitely far away, whose rays are as good as parallel. */
        SUN
    }

    private static final Vector3 DOWN = new Vector3(0, -1, 0);

    /** A sphere. */
    public static final LightShape SPHERE = new LightShape(Kind.SPHERE, DOWN, 0);

    /** A sharp sun in the zenith. */
    public static final LightShape SUN = SPHERE.withKind(Kind.SUN);

    public LightShape {
        requireNonNull(kind, "kind");
        requireNonNull(direction, "direction");
    }

    /** Such as {@code sun}; a sphere is a light without more ado. */
    public String name() {
        return kind == Kind.SPHERE ? "light" : kind.name().toLowerCase(Locale.ROOT);
    }

    /** The unit vector toward what shines; straight up if the direction has no length. */
    public Vector3 toward() {
        return (direction.length() > 0 ? direction.normalized() : DOWN).times(-1);
    }

    /** Sine of the angle that the radius of a sun's disc fills. */
    public double discSine() {
        return Math.sin(Math.toRadians(angularDiameterDegrees / 2));
    }
}
