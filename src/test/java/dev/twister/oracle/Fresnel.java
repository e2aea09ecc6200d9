package dev.twister.oracle;

/** What happens at the surface between two media, of which a ray comes from the one. */
final class Fresnel {
    private Fresnel() {}

    /**
     * The unpolarized reflectance.
     *
     * @param cosine of the angle of incidence
     * @param ratio index of refraction on the ray's side by that on the other
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
     * The refracted direction, by Snell's law: the part along the surface times the ratio, and what is left against the
     * normal.
     *
     * @param normal against the direction; both are unit vectors
     */
    static Vector refracted(Vector direction, Vector normal, double ratio) {
        Vector along = direction.minus(normal.times(direction.dot(normal))).times(ratio);
        return along.minus(normal.times(Math.sqrt(Math.max(0, 1 - along.dot(along)))));
    }
}
