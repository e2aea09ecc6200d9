package dev.twister.oracle;

/** Reflection and refraction at the surface between two media. */
final class Fresnel {
    private Fresnel() {}

    /**
     * Returns the unpolarized reflectance.
     *
     * @param cosine cosine of the angle of incidence
     * @param ratio index of refraction on the incident side divided by the one on the other side
     */
    static double reflectance(double cosine, double ratio) {
        double sineSquared = ratio * ratio * (1 - cosine * cosine);
        if (sineSquared >= 1) {
            return 1;
        }
        double other = Math.sqrt(1 - sineSquared);
        double perpendicular = (ratio * cosine - other) / (ratio * cosine + other);
        double parallel = (ratio * other - cosine) / (ratio * other + cosine);
        return (perpendicular * perpendicular + parallel * parallel) / 2;
    }

    /**
     * Returns the refracted direction by Snell's law: the tangential part times the ratio, and the remainder against
     * the normal.
     *
     * @param normal unit vector that points against the direction, which is a unit vector, too
     */
    static Vector refracted(Vector direction, Vector normal, double ratio) {
        Vector along = direction.minus(normal.times(direction.dot(normal))).times(ratio);
        return along.minus(normal.times(Math.sqrt(Math.max(0, 1 - along.dot(along)))));
    }
}
