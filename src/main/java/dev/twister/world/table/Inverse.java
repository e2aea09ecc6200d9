package dev.twister.world.table;

import dev.twister.mesh.Affine;
import dev.twister.scene.Vector3;

/** The inverse of a placement. */
final class Inverse {
    private Inverse() {}

    /** The inverse; not finite if there is none. */
    static Affine of(Affine placement) {
        Vector3 x = placement.axisX();
        Vector3 y = placement.axisY();
        Vector3 z = placement.axisZ();
        Vector3 first = y.cross(z);
        double scale = 1 / x.dot(first);
        Vector3 second = z.cross(x);
        Vector3 third = x.cross(y);
        Affine turned = new Affine(
                new Vector3(first.x(), second.x(), third.x()).times(scale),
                new Vector3(first.y(), second.y(), third.y()).times(scale),
                new Vector3(first.z(), second.z(), third.z()).times(scale),
                Vector3.ZERO);
        Vector3 back = turned.direction(placement.origin());
        return new Affine(turned.axisX(), turned.axisY(), turned.axisZ(), back.times(-1));
    }

    /** Whether all components are finite as floats. */
    static boolean isFinite(Affine affine) {
        return isFinite(affine.axisX())
                && isFinite(affine.axisY())
                && isFinite(affine.axisZ())
                && isFinite(affine.origin());
    }

    private static boolean isFinite(Vector3 vector) {
        return Float.isFinite((float) vector.x())
                && Float.isFinite((float) vector.y())
                && Float.isFinite((float) vector.z());
    }
}
