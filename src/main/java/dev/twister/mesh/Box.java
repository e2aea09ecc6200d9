package dev.twister.mesh;

import dev.twister.scene.Vector3;

/**
 * An axis-aligned box.
 *
 * @param least minimum of each coordinate
 * @param largest maximum of each coordinate
 */
public record Box(Vector3 least, Vector3 largest) {
    private static final double FAR = Double.POSITIVE_INFINITY;

    /** The bounds of no points. */
    public static final Box NONE = new Box(new Vector3(FAR, FAR, FAR), new Vector3(-FAR, -FAR, -FAR));

    /** The smallest box around this one and a point. */
    public Box with(Vector3 point) {
        return new Box(least.map(point, Math::min), largest.map(point, Math::max));
    }

    public Vector3 center() {
        return least.plus(largest).times(0.5);
    }

    /** Half of each side. */
    public Vector3 half() {
        return largest.minus(least).times(0.5);
    }
}
