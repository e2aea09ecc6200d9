package dev.twister.oracle;

/** The checkered square ground. */
record PlaneBody(double size, double height, Color oddColor, OracleMaterial material) implements Body {
    /** Shifts the checks' edges off round numbers, where rounding alone would decide. */
    private static final double CHECKER_SHIFT = 0x1p-10;

    /** Half of the side, slightly enlarged for the same reason. */
    private static final double REACH = 0.5 + 0x1p-17;

    @Override
    public double distance(Ray ray) {
        if (ray.direction().y() == 0) {
            return MISS;
        }
        double distance = (height - ray.origin().y()) / ray.direction().y();
        return distance > 0 && isInside(ray.at(distance)) ? distance : MISS;
    }

    /** A plane has no inside. */
    @Override
    public double distanceInside(Ray ray) {
        return MISS;
    }

    @Override
    public boolean isMetFromInside(Ray ray, Vector normal) {
        return false;
    }

    /** Returns whether the segment between two points crosses the square. */
    boolean separates(Vector from, Vector to) {
        double above = from.y() - height;
        double otherAbove = to.y() - height;
        return above * otherAbove < 0 && isInside(from.plus(to.minus(from).times(above / (above - otherAbove))));
    }

    private boolean isInside(Vector point) {
        return Math.abs(point.x()) <= REACH * size && Math.abs(point.z()) <= REACH * size;
    }

    @Override
    public Vector normal(Vector point) {
        return new Vector(0, 1, 0);
    }

    @Override
    public Color albedo(Vector point) {
        double squares = Math.floor(point.x() + CHECKER_SHIFT) + Math.floor(point.z() + CHECKER_SHIFT);
        Color base = squares % 2 == 0 ? material.color() : oddColor;
        return material.textured(base, point.x(), -point.z());
    }
}
