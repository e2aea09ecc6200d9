package dev.twister.gui.model;

import dev.twister.kernel.Layout;
import dev.twister.scene.Rgb;
import dev.twister.scene.Scene;
import dev.twister.scene.SceneLimits;
import dev.twister.scene.Sphere;
import dev.twister.scene.Vector3;
import dev.twister.world.FrameInput;

/** The sphere that the user inserts: in the middle of the picture, in front of what is visible there. */
public final class NewSphere {
    private static final double RADIUS = 1.5;
    private static final double REFLECTIVITY = 32;
    private static final int MOST_PILED = 1000;

    /** Where the middle of the picture shows the sky. */
    private static final double DISTANCE = 15;

    /** Turns of the hue from one sphere to the next, so that neighbors differ. */
    private static final double GOLDEN_RATIO = 0.6180339887;

    private NewSphere() {}

    /** The sphere, which touches what lies behind it, never sinks into the plane, and is in no other's place. */
    public static Sphere inFrontOf(FrameInput input, Scene scene) {
        double centerX = input.width() / 2.0;
        double centerY = input.height() / 2.0;
        PointerRay ray = PointerRay.through(input, centerX, centerY);
        Vector3 free = ray.along(distance(ray));
        double y = free.y();
        double ground = scene.ground().height();
        boolean above = scene.camera().position().y() >= ground;
        Vector3 center = SceneLimits.POSITION.clamp(
                new Vector3(free.x(), above ? Math.max(y, ground + RADIUS) : Math.min(y, ground - RADIUS), free.z()));
        return Sphere.of(
                besideOthers(center, scene, above ? 2 * RADIUS : -2 * RADIUS),
                RADIUS,
                color(scene.spheres().size()),
                REFLECTIVITY);
    }

    /** The picture may not show yet what was inserted a moment ago: spheres pile up there rather than being one. */
    private static Vector3 besideOthers(Vector3 wanted, Scene scene, double step) {
        Vector3 free = wanted;
        for (int tries = 0; tries < MOST_PILED && isTaken(free, scene); tries++) {
            free = new Vector3(free.x(), SceneLimits.POSITION.clamp(free.y() + step), free.z());
        }
        return free;
    }

    private static boolean isTaken(Vector3 center, Scene scene) {
        return scene.spheres().stream()
                .map(Sphere::position)
                .anyMatch(other -> Math.abs(other.x() - center.x()) < RADIUS
                        && Math.abs(other.y() - center.y()) < RADIUS
                        && Math.abs(other.z() - center.z()) < RADIUS);
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
