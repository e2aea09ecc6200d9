package dev.twister.kernel;

/**
 * What the facets of a surface reflect in the direction of the ray's origin, where {@link DirectionalAlbedo} has no
 * tables: facets that a finish stretches or tints. Sums over some visible facets.
 */
final class FinishAlbedos {
    /** Facets of a golden lattice: of stretched ones, whose albedos are spread wider, and of others. */
    private static final int MOST_FACETS = 64;

    private static final int FACETS = 16;
    private static final float LATTICE = 0.618034f;
    private static final float LEAST_COSINE = 1e-6f;
    private static final float LEAST_SQUARE = 1e-12f;

    private FinishAlbedos() {}

    /**
     * Writes the albedos of a perfect mirror, of the dielectric's reflection, and of that with its refraction; and the
     * mean cosine between the facets and the ray.
     *
     * @param path with {@link Layout#RATIO}
     */
    static void find(float[] path) {
        float mirror = 0f;
        float coat = 0f;
        float glass = 0f;
        float cosines = 0f;
        float cosineIn = Math.max(-Facet.directionDot(path, Layout.NORMAL), LEAST_COSINE);
        float in = Grain.masked(
                path, path[Layout.DIRECTION], path[Layout.DIRECTION + 1], path[Layout.DIRECTION + 2], cosineIn);
        float ratio = path[Layout.RATIO];
        int facets = path[Layout.STRETCH] > 1f ? MOST_FACETS : FACETS;
        for (int facet = 0; facet < facets; facet++) {
            path[Layout.FACET] = path[Layout.NORMAL];
            path[Layout.FACET + 1] = path[Layout.NORMAL + 1];
            path[Layout.FACET + 2] = path[Layout.NORMAL + 2];
            float turns = LATTICE * facet;
            Grain.sampleFacet(path, turns - (int) turns, (facet + 0.5f) / facets);
            float cosine = Math.min(Math.max(-Facet.directionDot(path, Layout.FACET), 0f), 1f);
            float reflected = weight(path, 1f, 2f * cosine, in);
            float fresnel = Refraction.reflectance(cosine, ratio);
            float refracted = weight(path, -ratio, -Refraction.along(cosine, ratio), in);
            mirror = mirror + reflected;
            coat = coat + fresnel * reflected;
            cosines = cosines + cosine * reflected;
            glass = glass + fresnel * reflected + (fresnel < 1f ? (1f - fresnel) * refracted : 0f);
        }
        path[Layout.FOUND_MIRROR] = mirror / facets;
        path[Layout.FOUND_COAT] = coat / facets;
        path[Layout.FOUND_GLASS] = glass / facets;
        path[Layout.FOUND_COSINE] = cosines / Math.max(mirror, LEAST_SQUARE);
    }

    /**
     * The part of light along {@code a * direction + b * facet} that is not masked; 0 on the surface's inner side.
     *
     * @param in {@link Grain#masked} of the ray's direction
     */
    private static float weight(float[] path, float a, float b, float in) {
        float x = a * path[Layout.DIRECTION] + b * path[Layout.FACET];
        float y = a * path[Layout.DIRECTION + 1] + b * path[Layout.FACET + 1];
        float z = a * path[Layout.DIRECTION + 2] + b * path[Layout.FACET + 2];
        float cosine = x * path[Layout.NORMAL] + y * path[Layout.NORMAL + 1] + z * path[Layout.NORMAL + 2];
        float weight = 0f;
        if (cosine > 0f) {
            weight = Facet.weight(path[Layout.ROUGHNESS], in, Grain.masked(path, x, y, z, cosine));
        }
        return weight;
    }
}
