package dev.twister.mesh;

import dev.twister.scene.Vector3;

/** An affine transform that maps the point (x, y, z) to {@code x * axisX + y * axisY + z * axisZ + origin}. */
public record Affine(Vector3 axisX, Vector3 axisY, Vector3 axisZ, Vector3 origin) {
    public static final Affine IDENTITY =
            new Affine(new Vector3(1, 0, 0), new Vector3(0, 1, 0), new Vector3(0, 0, 1), new Vector3(0, 0, 0));

    public Vector3 point(Vector3 point) {
        Vector3 direction = direction(point);
        return new Vector3(direction.x() + origin.x(), direction.y() + origin.y(), direction.z() + origin.z());
    }

    public Vector3 direction(Vector3 direction) {
        return new Vector3(
                direction.x() * axisX.x() + direction.y() * axisY.x() + direction.z() * axisZ.x(),
                direction.x() * axisX.y() + direction.y() * axisY.y() + direction.z() * axisZ.y(),
                direction.x() * axisX.z() + direction.y() * axisY.z() + direction.z() * axisZ.z());
    }

    /** The composition that applies {@code inner} first. */
    public Affine of(Affine inner) {
        return new Affine(direction(inner.axisX), direction(inner.axisY), direction(inner.axisZ), point(inner.origin));
    }
}
