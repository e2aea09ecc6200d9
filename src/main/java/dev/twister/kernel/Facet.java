package dev.twister.kernel;

/**
 * Microfacets of rough surfaces: GGX with alpha equal to the squared roughness, sampled from the visible normals (Dupuy
 * and Benyoub, "Sampling Visible GGX Normals with Spherical Caps", 2023).
 */
public final class Facet {
    /** Lower bound of a squared cosine. */
    public static final float LEAST_SQUARE = 1e-12f;

    private static final float LEAST_SPREAD = 1e-30f;

    private Facet() {}

    /**
     * Writes the normal of the microfacet that the path's ray hits, turned toward the ray's origin. For a smooth
     * surface it is the surface's normal.
     *
     * @param path {@link Layout#PATH_LENGTH} floats
     */
    public static void find(float[] path, float[] frame) {
        float side = directionDot(path, Layout.NORMAL) > 0f ? -1f : 1f;
        path[Layout.FACET] = side * path[Layout.NORMAL];
        path[Layout.FACET + 1] = side * path[Layout.NORMAL + 1];
        path[Layout.FACET + 2] = side * path[Layout.NORMAL + 2];
        if (path[Layout.ROUGHNESS] > 0f) {
            int place = Noise.surface((int) path[Layout.BOUNCE]);
            sample(path, Noise.fresh(path, place, frame), Noise.fresh(path, place + 1, frame));
        }
    }

    /** Replaces the facet, initially the surface's normal, by a sample from two random numbers in [0, 1). */
    static void sample(float[] path, float first, float second) {
        float alpha = path[Layout.ROUGHNESS] * path[Layout.ROUGHNESS];
        float normalX = path[Layout.FACET];
        float normalY = path[Layout.FACET + 1];
        float normalZ = path[Layout.FACET + 2];
        // Orthonormal basis without singularities (Duff et al. 2017).
        float sign = normalZ < 0f ? -1f : 1f;
        float a = -1f / (sign + normalZ);
        float b = normalX * normalY * a;
        float tangentX = 1f + sign * normalX * normalX * a;
        float tangentY = sign * b;
        float tangentZ = -sign * normalX;
        float crossX = b;
        float crossY = sign + normalY * normalY * a;
        float crossZ = -normalY;
        float viewX = -path[Layout.DIRECTION];
        float viewY = -path[Layout.DIRECTION + 1];
        float viewZ = -path[Layout.DIRECTION + 2];
        float x = alpha * (viewX * tangentX + viewY * tangentY + viewZ * tangentZ);
        float y = alpha * (viewX * crossX + viewY * crossY + viewZ * crossZ);
        float z = Math.max(viewX * normalX + viewY * normalY + viewZ * normalZ, 0f);
        float inverse = KernelMath.inverseRoot(x * x + y * y + z * z);
        x = x * inverse;
        y = y * inverse;
        z = z * inverse;
        float height = (1f - second) * (1f + z) - z;
        float radius = (float) Math.sqrt(Math.min(Math.max(1f - height * height, 0f), 1f));
        x = alpha * (x + radius * KernelMath.cosineOfTurns(first));
        y = alpha * (y + radius * KernelMath.sineOfTurns(first));
        z = z + height;
        inverse = KernelMath.inverseRoot(x * x + y * y + z * z);
        path[Layout.FACET] = (x * tangentX + y * crossX + z * normalX) * inverse;
        path[Layout.FACET + 1] = (x * tangentY + y * crossY + z * normalY) * inverse;
        path[Layout.FACET + 2] = (x * tangentZ + y * crossZ + z * normalZ) * inverse;
    }

    /**
     * G2 / G1 of Smith's height-correlated masking and shadowing: the part of the sampled light that leaves the
     * surface.
     *
     * @param roughness in [0, 1]
     * @param cosineIn cosine between normal and incoming ray, at least 0
     * @param cosineOut cosine between normal and outgoing ray, at least 0
     */
    public static float weight(float roughness, float cosineIn, float cosineOut) {
        float alpha = roughness * roughness;
        float in = 1f + lambda(alpha, cosineIn);
        return in / (in + lambda(alpha, cosineOut));
    }

    /**
     * Density of a visible normal, divided by the cosine between it and the incoming ray: {@code G1 * D / N.V}.
     *
     * @param alpha squared roughness, above 0
     * @param cosine cosine between the surface's normal and the facet's
     * @param cosineIn cosine between the surface's normal and the incoming ray, above 0
     */
    static float visibleDensity(float alpha, float cosine, float cosineIn) {
        float squared = Math.min(cosine * cosine, 1f);
        // The sine and not alpha^2 - 1, which would lose the digits of a narrow lobe.
        float spread = alpha * alpha * squared + (1f - squared);
        float facets = alpha * alpha / (KernelMath.PI * Math.max(spread * spread, LEAST_SPREAD));
        return facets / (cosineIn * (1f + lambda(alpha, cosineIn)));
    }

    private static float lambda(float alpha, float cosine) {
        float squared = Math.max(cosine * cosine, LEAST_SQUARE);
        return 0.5f * (float) Math.sqrt(1f + alpha * alpha * (1f - Math.min(squared, 1f)) / squared) - 0.5f;
    }

    /** Dot product of the ray's direction and a vector of the path. */
    static float directionDot(float[] path, int vector) {
        return path[Layout.DIRECTION] * path[vector]
                + path[Layout.DIRECTION + 1] * path[vector + 1]
                + path[Layout.DIRECTION + 2] * path[vector + 2];
    }
}
