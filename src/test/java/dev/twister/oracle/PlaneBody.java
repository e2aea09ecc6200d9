package dev.twister.oracle;

/** The checkered square ground. */
record PlaneBody(double size, double height, Color evenColor, Color oddColor, double reflectivity) implements Body {
    /** Keeps the checks' edges off round numbers, where rounding alone decides. */
    private static final double CHECKER_SHIFT = 0x1p-10;

    @Override
    public double distance(Ray ray) {
        if (ray.direction().y() == 0) {
            return MISS;
        }
        double distance = (height - ray.origin().y()) / ray.direction().y();
        Vector point = ray.at(distance);
        boolean inside = Math.abs(point.x()) <= size / 2 && Math.abs(point.z()) <= size / 2;
        return distance > 0 && inside ? distance : MISS;
    }

    @Override
    public Vector normal(Vector point) {
        return new Vector(0, 1, 0);
    }

    @Override
    public Color albedo(Vector point) {
        double squares = Math.floor(point.x() + CHECKER_SHIFT) + Math.floor(point.z() + CHECKER_SHIFT);
        return squares % 2 == 0 ? evenColor : oddColor;
    }
}
