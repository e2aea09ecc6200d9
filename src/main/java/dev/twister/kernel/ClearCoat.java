package dev.twister.kernel;

/**
 * A clear coat over a surface: GGX facets of a dielectric with the index of refraction 1.5 and a normal of their own.
 */
final class ClearCoat {
    /** Index of refraction outside of the coat divided by that inside. */
    private static final float RATIO = 1f / 1.5f;

    private static final float LEAST_COSINE = 1e-6f;

    private ClearCoat() {}

    /**
     * The part of white light from the ray's origin that a full coat reflects.
     *
     * @param table place in {@code looks} of the coat's table of {@link DirectionalAlbedo}
     */
    static float albedo(float[] path, int table, float[] looks) {
        float roughness = path[Layout.FINISH + Layout.FINISH_COAT_ROUGHNESS];
        float cosine = cosineIn(path);
        float albedo = Refraction.reflectance(cosine, RATIO);
        if (roughness > 0f) {
            albedo = DirectionalAlbedo.of(table, roughness, cosine, looks);
        }
        return albedo;
    }

    private static float cosineIn(float[] path) {
        return Math.min(Math.max(-Facet.directionDot(path, Layout.COAT_NORMAL), LEAST_COSINE), 1f);
    }

    /** 1 if the coat scatters light in other than single directions, else 0. */
    static int scatters(float[] path) {
        return (path[Layout.FINISH + Layout.FINISH_COAT_ROUGHNESS] > 0f ? 1 : 0)
                & (path[Layout.CHOICE_COAT] > 0f ? 1 : 0);
    }

    /**
     * Adds the rough coat's light to {@link Layout#SCATTERED}, for a direction above the surface.
     *
     * @return density of the direction by this lobe
     */
    static float evaluate(float[] path, float x, float y, float z) {
        float density = 0f;
        float cosineOut =
                x * path[Layout.COAT_NORMAL] + y * path[Layout.COAT_NORMAL + 1] + z * path[Layout.COAT_NORMAL + 2];
        if ((scatters(path) & (cosineOut > 0f ? 1 : 0)) != 0) {
            float halfX = x - path[Layout.DIRECTION];
            float halfY = y - path[Layout.DIRECTION + 1];
            float halfZ = z - path[Layout.DIRECTION + 2];
            float inverse = KernelMath.inverseRoot(halfX * halfX + halfY * halfY + halfZ * halfZ);
            float facet = (halfX * path[Layout.COAT_NORMAL]
                            + halfY * path[Layout.COAT_NORMAL + 1]
                            + halfZ * path[Layout.COAT_NORMAL + 2])
                    * inverse;
            float view = (halfX * x + halfY * y + halfZ * z) * inverse;
            float roughness = path[Layout.FINISH + Layout.FINISH_COAT_ROUGHNESS];
            float cosineIn = cosineIn(path);
            float facets = 0.25f * Facet.visibleDensity(roughness * roughness, Math.abs(facet), cosineIn);
            float weight = facets * Facet.weight(roughness, cosineIn, cosineOut) * reflected(path, view);
            for (int channel = 0; channel < 3; channel++) {
                path[Layout.SCATTERED + channel] = path[Layout.SCATTERED + channel] + weight;
            }
            density = path[Layout.CHOICE_COAT] * facets;
        }
        return density;
    }

    private static float reflected(float[] path, float cosine) {
        float reflectance = Refraction.reflectance(Math.min(Math.max(cosine, 0f), 1f), RATIO);
        return path[Layout.COVER_COAT] * reflectance;
    }

    /** Writes the facet that the ray meets, from two random numbers in [0, 1). */
    static void sampleFacet(float[] path, float first, float second) {
        path[Layout.FACET] = path[Layout.COAT_NORMAL];
        path[Layout.FACET + 1] = path[Layout.COAT_NORMAL + 1];
        path[Layout.FACET + 2] = path[Layout.COAT_NORMAL + 2];
        float roughness = path[Layout.FINISH + Layout.FINISH_COAT_ROUGHNESS];
        if (roughness > 0f) {
            float below = path[Layout.ROUGHNESS];
            path[Layout.ROUGHNESS] = roughness;
            Facet.sample(path, first, second);
            path[Layout.ROUGHNESS] = below;
        }
    }

    /** The factor of the throughput of a ray that the smooth coat mirrors. */
    static float mirrored(float[] path) {
        float faceOut = path[Layout.FACE] * path[Layout.NEXT_DIRECTION]
                + path[Layout.FACE + 1] * path[Layout.NEXT_DIRECTION + 1]
                + path[Layout.FACE + 2] * path[Layout.NEXT_DIRECTION + 2];
        int leaves = (faceOut > 0f ? 1 : 0) & (path[Layout.CHOICE_COAT] > 0f ? 1 : 0);
        return leaves != 0 ? reflected(path, cosineIn(path)) / path[Layout.CHOICE_COAT] : 0f;
    }
}
