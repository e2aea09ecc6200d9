package dev.twister.kernel;

/**
 * Anisotropic facets: those of {@link Facet} stretched along a direction of the surface, the grain, as glTF's
 * {@code KHR_materials_anisotropy} has it. In a space pressed together along the grain they are as others.
 */
final class Grain {
    /** Facets of a smooth surface can't be stretched. */
    private static final float LEAST_ROUGHNESS = 0.03f;

    private Grain() {}

    /** Writes by how much the facets are stretched. */
    static void begin(float[] path) {
        float strength = path[Layout.FINISH + Layout.FINISH_ANISOTROPY];
        int grained = strength > 0f ? 1 : 0;
        float roughness = path[Layout.ROUGHNESS];
        roughness = grained != 0 ? Math.max(roughness, LEAST_ROUGHNESS) : roughness;
        path[Layout.ROUGHNESS] = roughness;
        float alpha = roughness * roughness;
        path[Layout.STRETCH] = grained != 0 ? 1f + (1f - alpha) * strength * strength / alpha : 1f;
    }

    /**
     * The cosine that decides how much of a direction facets mask: that of the direction stretched along the grain, by
     * which stretched facets are as others.
     *
     * @param cosine between the direction and the normal
     */
    static float masked(float[] path, float x, float y, float z, float cosine) {
        float along = x * path[Layout.GRAIN] + y * path[Layout.GRAIN + 1] + z * path[Layout.GRAIN + 2];
        float stretch = path[Layout.STRETCH];
        return cosine * KernelMath.inverseRoot(1f + (stretch * stretch - 1f) * along * along);
    }

    /**
     * {@link Facet#visibleDensity} of a unit facet, which is pressed together along the grain to where facets are as
     * others.
     *
     * @param cosine between the facet and the normal
     */
    static float visibleDensity(float[] path, float x, float y, float z, float cosine, float cosineIn, float alpha) {
        float along = x * path[Layout.GRAIN] + y * path[Layout.GRAIN + 1] + z * path[Layout.GRAIN + 2];
        float stretch = path[Layout.STRETCH];
        float squared = 1f + (1f / (stretch * stretch) - 1f) * along * along;
        float masked =
                masked(path, path[Layout.DIRECTION], path[Layout.DIRECTION + 1], path[Layout.DIRECTION + 2], cosineIn);
        float density = Facet.visibleDensity(alpha, cosine * KernelMath.inverseRoot(squared), masked);
        return density * masked / (cosineIn * stretch * squared * squared);
    }

    /** As {@link Facet#sample}, of stretched facets: in the space where they are as others. */
    static void sampleFacet(float[] path, float first, float second) {
        float x = path[Layout.DIRECTION];
        float y = path[Layout.DIRECTION + 1];
        float z = path[Layout.DIRECTION + 2];
        stretch(path, Layout.DIRECTION);
        Facet.sample(path, first, second);
        path[Layout.DIRECTION] = x;
        path[Layout.DIRECTION + 1] = y;
        path[Layout.DIRECTION + 2] = z;
        stretch(path, Layout.FACET);
        float facetX = path[Layout.FACET];
        float facetY = path[Layout.FACET + 1];
        float facetZ = path[Layout.FACET + 2];
        float inverse = KernelMath.inverseRoot(facetX * facetX + facetY * facetY + facetZ * facetZ);
        path[Layout.FACET] = facetX * inverse;
        path[Layout.FACET + 1] = facetY * inverse;
        path[Layout.FACET + 2] = facetZ * inverse;
    }

    private static void stretch(float[] path, int vector) {
        float along = path[vector] * path[Layout.GRAIN]
                + path[vector + 1] * path[Layout.GRAIN + 1]
                + path[vector + 2] * path[Layout.GRAIN + 2];
        float more = (path[Layout.STRETCH] - 1f) * along;
        path[vector] = path[vector] + more * path[Layout.GRAIN];
        path[vector + 1] = path[vector + 1] + more * path[Layout.GRAIN + 1];
        path[vector + 2] = path[vector + 2] + more * path[Layout.GRAIN + 2];
    }
}
