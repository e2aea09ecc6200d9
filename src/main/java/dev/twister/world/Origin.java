package dev.twister.world;

import dev.twister.scene.Vector3;

/** Where a world's coordinates begin: floats lose digits far away from there. */
final class Origin {
    /** Of the origin, in meters along each axis: so far floats keep a quarter of a millimeter. */
    private static final double NEAR = 4096;

    private Origin() {}

    /**
     * The scene's own where the place is near it, else the even point next to the place: even, so that checks keep
     * their colors.
     */
    static Vector3 near(Vector3 place) {
        Vector3 own = new Vector3(0, 0, 0);
        return isNear(own, place) ? own : new Vector3(even(place.x()), even(place.y()), even(place.z()));
    }

    static boolean isNear(Vector3 origin, Vector3 place) {
        return Math.abs(place.x() - origin.x()) <= NEAR
                && Math.abs(place.y() - origin.y()) <= NEAR
                && Math.abs(place.z() - origin.z()) <= NEAR;
    }

    private static double even(double coordinate) {
        return 2 * Math.rint(coordinate / 2);
    }
}
