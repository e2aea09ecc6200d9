package dev.twister.mesh;

import dev.twister.scene.Vector3;

/** An affine transform that maps the point (x, y, z) to {@code x * axisX + y * axisY + z * axisZ + origin}. */
public record Affine(Vector3 axisX, Vector3 axisY, Vector3 axisZ, Vector3 origin) {
    public static final Affine IDENTITY =
            new Affine(new Vector3(1, 0, 0), new Vector3(0, 1, 0), new Vector3(0, 0, 1), Vector3.ZERO);

    /** The transform that adds a vector. */
    public static Affine moving(Vector3 by) {
        return new Affine(IDENTITY.axisX, IDENTITY.axisY, IDENTITY.axisZ, by);
    }

    public Vector3 point(Vector3 point) {
        return direction(point).plus(origin);
    }

    public Vector3 direction(Vector3 direction) {
        return axisX.times(direction.x()).plus(axisY.times(direction.y())).plus(axisZ.times(direction.z()));
    }

    /** A normal, perpendicular to what it was perpendicular to; not normalized. */
    public Vector3 normal(Vector3 normal) {
        return axisY.cross(axisZ)
                .times(normal.x())
                .plus(axisZ.cross(axisX).times(normal.y()))
                .plus(axisX.cross(axisY).times(normal.z()));
    }

    /** The composition that applies {@code inner} first. */
    public Affine of(Affine inner) {
        return new Affine(direction(inner.axisX), direction(inner.axisY), direction(inner.axisZ), point(inner.origin));
    }
}
