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

    /** The side of the surface that counts for light to pass or to be reflected, on the side that a ray comes from. */
    default Vector face(Ray ray, Vector point) {
        Vector normal = normal(ray, point);
        return ray.direction().dot(normal) > 0 ? normal.times(-1) : normal;
    }

    /** Returns whether the side that a ray meets emits light; spheres emit outward. */
    default boolean emits(Ray ray, boolean fromInside) {
        return material().emits() && !fromInside;
    }

    /** The part of the emission that goes against a direction. */
    default double part(Vector direction) {
        return 1;
    }

    OracleMaterial material();

    /** The material at a point, as maps vary it. */
    default OracleMaterial material(Vector point) {
        return material();
    }

    /** What multiplies the ambient light at a point. */
    default double open(Vector point) {
        return 1;
    }

    /** What multiplies light that passes the surface at a point. */
    default Color passing(Vector point) {
        return albedo(point);
    }
}
