package dev.twister.oracle;

/** What a ray can meet. */
sealed interface Body permits SphereBody, PlaneBody {
    /** What {@link #distance} is where the ray does not meet the body. */
    double MISS = Double.POSITIVE_INFINITY;

    double distance(Ray ray);

    Vector normal(Vector point);

    Color albedo(Vector point);

    double reflectivity();
}
