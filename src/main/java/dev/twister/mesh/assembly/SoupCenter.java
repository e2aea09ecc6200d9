package dev.twister.mesh.assembly;

import dev.twister.mesh.Box;
import dev.twister.scene.Vector3;

/** The center that positions are relative to, so that floats place them as exactly as near the origin. */
final class SoupCenter {
    /** Up to this many times half of the largest side away, floats at the origin are about as exact. */
    private static final double NEAR = 4;

    private SoupCenter() {}

    /**
     * The center of a box, rounded to a multiple of a power of two, so that floats of the file stay exact; zero for a
     * box near the origin.
     */
    static Vector3 of(Box bounds) {
        double half = largest(bounds.half());
        Vector3 center = bounds.center();
        if (!(half > 0) || !(largest(center) > NEAR * half)) {
            return Vector3.ZERO;
        }
        double unit = Math.scalb(1.0, Math.getExponent(half));
        return new Vector3(rounded(center.x(), unit), rounded(center.y(), unit), rounded(center.z(), unit));
    }

    private static double rounded(double value, double unit) {
        return Math.rint(value / unit) * unit;
    }

    private static double largest(Vector3 vector) {
        return Math.max(Math.abs(vector.x()), Math.max(Math.abs(vector.y()), Math.abs(vector.z())));
    }
}
