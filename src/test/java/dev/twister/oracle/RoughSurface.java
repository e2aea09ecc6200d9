package dev.twister.oracle;

/** GGX facets seen from one side of a surface, with Smith's height-correlated masking and shadowing. */
record RoughSurface(double alpha) {
    static RoughSurface of(double roughness) {
        return new RoughSurface(roughness * roughness);
    }

    /**
     * Samples a visible facet by Dupuy and Benyoub (2023): a point of the spherical cap of the stretched view
     * direction, in the frame of Duff et al. (2017).
     *
     * @param normal the surface normal on the viewer's side
     * @param toViewer unit vector
     * @param turns azimuth in [0, 1)
     * @param height in [0, 1)
     */
    Vector facet(Vector normal, Vector toViewer, double turns, double height) {
        double sign = normal.z() < 0 ? -1 : 1;
        double a = -1 / (sign + normal.z());
        double b = normal.x() * normal.y() * a;
        Vector tangent = new Vector(1 + sign * normal.x() * normal.x() * a, sign * b, -sign * normal.x());
        Vector bitangent = new Vector(b, sign + normal.y() * normal.y() * a, -normal.y());
        Vector stretched = new Vector(
                        alpha * toViewer.dot(tangent), alpha * toViewer.dot(bitangent), toViewer.dot(normal))
                .normalized();
        double z = (1 - height) * (1 + stretched.z()) - stretched.z();
        double sine = Math.sqrt(Math.clamp(1 - z * z, 0, 1));
        Vector onCap = new Vector(sine * Math.cos(2 * Math.PI * turns), sine * Math.sin(2 * Math.PI * turns), z);
        Vector half = stretched.plus(onCap);
        return tangent.times(alpha * half.x())
                .plus(bitangent.times(alpha * half.y()))
                .plus(normal.times(half.z()))
                .normalized();
    }

    /** Returns G2 / G1, or 0 if the light would continue on the wrong side. */
    double weight(double cosineIn, double cosineOut) {
        return cosineOut > 0 ? (1 + lambda(cosineIn)) / (1 + lambda(cosineIn) + lambda(cosineOut)) : 0;
    }

    private double lambda(double cosine) {
        double tangentSquared = (1 - cosine * cosine) / (cosine * cosine);
        return (Math.sqrt(1 + alpha * alpha * Math.max(0, tangentSquared)) - 1) / 2;
    }
}
