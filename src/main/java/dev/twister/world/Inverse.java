package dev.twister.world;

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
        Vector3 first = cross(y, z);
        double scale = 1 / (x.x() * first.x() + x.y() * first.y() + x.z() * first.z());
        Vector3 second = cross(z, x);
        Vector3 third = cross(x, y);
        Affine turned = new Affine(
                new Vector3(scale * first.x(), scale * second.x(), scale * third.x()),
                new Vector3(scale * first.y(), scale * second.y(), scale * third.y()),
                new Vector3(scale * first.z(), scale * second.z(), scale * third.z()),
                new Vector3(0, 0, 0));
        Vector3 back = turned.direction(placement.origin());
        return new Affine(turned.axisX(), turned.axisY(), turned.axisZ(), new Vector3(-back.x(), -back.y(), -back.z()));
    }

    private static Vector3 cross(Vector3 a, Vector3 b) {
        return new Vector3(a.y() * b.z() - a.z() * b.y(), a.z() * b.x() - a.x() * b.z(), a.x() * b.y() - a.y() * b.x());
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
