package dev.twister.mesh;

import dev.twister.scene.Vector3;

/**
 * An axis-aligned box.
 *
 * @param least minimum of each coordinate
 * @param largest maximum of each coordinate
 */
public record Bounds(Vector3 least, Vector3 largest) {
    private static final double FAR = Double.POSITIVE_INFINITY;

    /** The bounds of no points. */
    public static final Bounds NONE = new Bounds(new Vector3(FAR, FAR, FAR), new Vector3(-FAR, -FAR, -FAR));

    /** The smallest box around this one and a point. */
    public Bounds with(Vector3 point) {
        return new Bounds(
                new Vector3(
                        Math.min(least.x(), point.x()), Math.min(least.y(), point.y()), Math.min(least.z(), point.z())),
                new Vector3(
                        Math.max(largest.x(), point.x()),
                        Math.max(largest.y(), point.y()),
                        Math.max(largest.z(), point.z())));
    }

    public Vector3 center() {
        return new Vector3((least.x() + largest.x()) / 2, (least.y() + largest.y()) / 2, (least.z() + largest.z()) / 2);
    }

    /** Half of each side. */
    public Vector3 half() {
        return new Vector3((largest.x() - least.x()) / 2, (largest.y() - least.y()) / 2, (largest.z() - least.z()) / 2);
    }
}
