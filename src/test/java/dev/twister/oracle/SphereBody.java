package dev.twister.oracle;

/** A sphere; the light is one too, its colour a radiance. */
record SphereBody(Vector center, double radius, Color color, double reflectivity) implements Body {
    /** The near root of {@code |origin + t direction - center|^2 = radius^2}, where that is above 0. */
    @Override
    public double distance(Ray ray) {
        Vector fromCenter = ray.origin().minus(center);
        double halfB = fromCenter.dot(ray.direction());
        double c = fromCenter.dot(fromCenter) - radius * radius;
        double discriminant = halfB * halfB - c;
        if (discriminant < 0) {
            return MISS;
        }
        double nearRoot = -halfB - Math.sqrt(discriminant);
        return nearRoot > 0 ? nearRoot : MISS;
    }

    @Override
    public Vector normal(Vector point) {
        return point.minus(center).normalized();
    }

    @Override
    public Color albedo(Vector point) {
        return color;
    }
}
