package dev.twister.oracle;

/** What a ray can meet. */
sealed interface Body permits SphereBody, PlaneBody, TriangleBody {
    /** What {@link #distance} is where the ray does not meet the body. */
    double MISS = Double.POSITIVE_INFINITY;

    double distance(Ray ray);

    /** The same for a ray that leaves the body's surface and goes on inside. */
    double distanceInside(Ray ray);

    /** Outward; the plane's points up. */
    Vector normal(Vector point);

    /** The normal that a ray sees, which comes from outside or meets a triangle. */
    default Vector normal(Ray ray, Vector point) {
        return normal(point);
    }

    /** Whether a ray meets the surface at that normal from inside. */
    boolean isMetFromInside(Ray ray, Vector normal);

    Color albedo(Vector point);

    OracleMaterial material();
}
