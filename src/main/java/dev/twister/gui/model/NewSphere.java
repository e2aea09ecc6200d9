package dev.twister.gui.model;

import dev.twister.kernel.Layout;
import dev.twister.scene.Rgb;
import dev.twister.scene.Scene;
import dev.twister.scene.SceneLimits;
import dev.twister.scene.Sphere;
import dev.twister.scene.Vector3;
import dev.twister.world.FrameInput;

/** The sphere that the user inserts: on the ground, in the middle of the picture. */
public final class NewSphere {
    private static final double RADIUS = 1.5;
    private static final double REFLECTIVITY = 32;
    private static final int MOST_TRIES = 200;

    /** Between the centers of new spheres beside each other, in radii. */
    private static final double APART = 2.2;

    /** Of the sum of the radii: so near is in the same place. */
    private static final double TOUCHING = 0.8;

    /** The sine of the angle above the horizon from which the camera looks up. */
    private static final double STEEPEST_UP = 0.15;

    /** Where the middle of the picture shows the sky. */
    private static final double DISTANCE = 15;

    /** Turns of the hue from one sphere to the next, so that neighbors differ. */
    private static final double GOLDEN_RATIO = 0.6180339887;

    private NewSphere() {}

    /**
     * The sphere. It stands on the ground where the camera looks, before what is seen there and beside what stands
     * there; in the air if the camera looks up.
     */
    public static Sphere inFrontOf(FrameInput input, Scene scene) {
        PointerRay ray = PointerRay.through(input, input.width() / 2.0, input.height() / 2.0);
        Vector3 free = ray.along(distance(ray));
        double ground = scene.ground().height();
        boolean above = scene.camera().position().y() >= ground;
        double standing = above ? ground + RADIUS : ground - RADIUS;
        double y = ray.direction(1) > STEEPEST_UP ? Math.max(free.y(), standing) : standing;
        Vector3 center = SceneLimits.POSITION.clamp(new Vector3(free.x(), above ? y : standing, free.z()));
        return Sphere.of(
                besideOthers(center, scene), RADIUS, color(scene.spheres().size()), REFLECTIVITY);
    }

    /** To the right and to the left by turns; the picture may not show yet what was inserted a moment ago. */
    private static Vector3 besideOthers(Vector3 wanted, Scene scene) {
        double yaw = Math.toRadians(scene.camera().yawDegrees());
        Vector3 right = new Vector3(Math.cos(yaw), 0, -Math.sin(yaw)).times(APART * RADIUS);
        Vector3 free = wanted;
        for (int tries = 1; tries < MOST_TRIES && isTaken(free, scene); tries++) {
            int side = tries % 2 == 1 ? (tries + 1) / 2 : -tries / 2;
            free = SceneLimits.POSITION.clamp(wanted.plus(right.times(side)));
        }
        return free;
    }

    private static boolean isTaken(Vector3 center, Scene scene) {
        return scene.spheres().stream()
                        .anyMatch(
                                other -> other.position().minus(center).length() < TOUCHING * (RADIUS + other.radius()))
                || scene.meshes().stream()
                        .anyMatch(mesh -> mesh.position().minus(center).length() < RADIUS);
    }

    private static double distance(PointerRay ray) {
        // At least beyond the camera itself, else it would be inside the sphere.
        return ray.body() == Layout.NOTHING
                ? DISTANCE
                : Math.max(2 * RADIUS, Math.min(ray.distance(), DISTANCE) - RADIUS);
    }

    private static Rgb color(int spheres) {
        double hue = spheres * GOLDEN_RATIO;
        return new Rgb(channel(hue), channel(hue + 1.0 / 3), channel(hue + 2.0 / 3));
    }

    private static double channel(double turns) {
        return 0.5 + 0.4 * Math.cos(2 * Math.PI * turns);
    }
}
