package dev.twister.scene.generate;

import dev.twister.scene.Rgb;
import dev.twister.scene.Sphere;
import dev.twister.scene.Vector3;

/** Rounds what a generator makes, so that its files stay small and a person can read them. */
final class Rounding {
    private static final double STEPS = 10_000;

    private Rounding() {}

    /** To 4 decimals. */
    static double of(double number) {
        // Adding 0 turns -0.0 into 0.0.
        return Math.rint(number * STEPS) / STEPS + 0.0;
    }

    static Vector3 of(Vector3 vector) {
        return vector.map(Rounding::of);
    }

    static Rgb of(Rgb color) {
        return new Rgb(of(color.red()), of(color.green()), of(color.blue()));
    }

    static Sphere of(Sphere sphere) {
        return sphere.withPosition(of(sphere.position()))
                .withRadius(of(sphere.radius()))
                .withColor(of(sphere.color()))
                .withReflectivity(of(sphere.reflectivity()));
    }
}
