package dev.twister.oracle;

/** A surface that a ray can hit. */
sealed interface Body permits SphereBody, PlaneBody, TriangleBody {
    /** The value of {@link #distance} if the ray misses the body. */
    double MISS = Double.POSITIVE_INFINITY;

    double distance(Ray ray);

    /** Distance for a ray that leaves the body's surface and continues inside. */
    double distanceInside(Ray ray);

    /** The outward normal; the plane's points up. */
    Vector normal(Vector point);

    /** The normal facing a ray that comes from outside or hits a triangle. */
    default Vector normal(Ray ray, Vector point) {
        return normal(point);
    }

    /** Returns whether a ray hits the surface with this normal from inside. */
    boolean isMetFromInside(Ray ray, Vector normal);

    Color albedo(Vector point);

    OracleMaterial material();
}
