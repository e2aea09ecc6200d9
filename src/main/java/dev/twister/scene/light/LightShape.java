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
 * @param coneAngleDegrees between opposite sides of a spot's cone, outside of which it is dark
 * @param coneBlend part of the cone's half angle, from the border inward, over which a spot's light fades out
 */
@Copied
public record LightShape(
        Kind kind, Vector3 direction, double angularDiameterDegrees, double coneAngleDegrees, double coneBlend)
        implements LightShapeCopy.With {
    /** What gives the light. */
    public enum Kind {
        /** A sphere of some radius at a place. */
        SPHERE,
        /** A disc infinitely far away, whose rays are as good as parallel. */
        SUN,
        /** A sphere that shines in a cone of directions. */
        SPOT
    }

    private static final Vector3 DOWN = new Vector3(0, -1, 0);
    private static final double USUAL_CONE = 45;
    private static final double USUAL_BLEND = 0.15;

    /** A sphere. */
    public static final LightShape SPHERE = new LightShape(Kind.SPHERE, DOWN, 0, USUAL_CONE, USUAL_BLEND);

    /** A sharp sun in the zenith. */
    public static final LightShape SUN = SPHERE.withKind(Kind.SUN);

    /** A spot that shines straight down. */
    public static final LightShape SPOT = SPHERE.withKind(Kind.SPOT);

    public LightShape {
        requireNonNull(kind, "kind");
        requireNonNull(direction, "direction");
        // What a light of another kind has is the usual, so that lights that shine alike are equal.
        direction = kind == Kind.SPHERE ? DOWN : direction;
        angularDiameterDegrees = kind == Kind.SUN ? angularDiameterDegrees : 0;
        coneAngleDegrees = kind == Kind.SPOT ? coneAngleDegrees : USUAL_CONE;
        coneBlend = kind == Kind.SPOT ? coneBlend : USUAL_BLEND;
    }

    /** Such as {@code sun}; a sphere is a light without more ado. */
    public String name() {
        return kind == Kind.SPHERE ? "light" : kind.name().toLowerCase(Locale.ROOT);
    }

    /** The unit vector toward what shines; straight up if the direction has no length. */
    public Vector3 toward() {
        return (direction.length() > 0 ? direction.normalized() : DOWN).times(-1);
    }

    /** Cosine of half the angle of a spot's cone, where it is dark. */
    public double outerCosine() {
        return Math.cos(Math.toRadians(coneAngleDegrees / 2));
    }

    /** Cosine of the angle with a spot's direction from which on its light fades out. */
    public double innerCosine() {
        return Math.cos(Math.toRadians(coneAngleDegrees / 2 * (1 - coneBlend)));
    }

    /** Sine of the angle that the radius of a sun's disc fills. */
    public double discSine() {
        return Math.sin(Math.toRadians(angularDiameterDegrees / 2));
    }
}
