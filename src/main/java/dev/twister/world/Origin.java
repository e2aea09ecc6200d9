package dev.twister.world;

import dev.twister.scene.Vector3;

/** Chooses the origin of a world's coordinates: floats lose precision far from it. */
final class Origin {
    /** Largest distance along each axis, in meters, at which floats are still accurate to 0.25 mm. */
    private static final double NEAR = 4096;

    private Origin() {}

    /**
     * The scene's own origin if the point is near it, else the even integer point nearest to the point. Even, so that
     * the checker keeps its colors.
     */
    static Vector3 near(Vector3 place) {
        return isNear(Vector3.ZERO, place) ? Vector3.ZERO : place.map(Origin::even);
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
