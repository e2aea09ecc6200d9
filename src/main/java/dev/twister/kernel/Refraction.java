package dev.twister.kernel;

/** What passes a surface between two media, and which way. */
public final class Refraction {
    private Refraction() {}

    /**
     * The unpolarized Fresnel reflectance of a dielectric, in [0, 1]; 1 at total internal reflection.
     *
     * @param cosine between the ray, turned back, and the facet's normal, in [0, 1]
     * @param ratio index of refraction where the ray comes from by that of where it goes to
     */
    public static float reflectance(float cosine, float ratio) {
        float passedSquared = passedSquared(cosine, ratio);
        float reflectance = 1f;
        if (passedSquared > 0f) {
            float passed = (float) Math.sqrt(passedSquared);
            float across = (ratio * cosine - passed) / (ratio * cosine + passed);
            float along = (cosine - ratio * passed) / (cosine + ratio * passed);
            reflectance = 0.5f * (across * across + along * along);
        }
        return reflectance;
    }

    /**
     * The refracted ray is {@code ratio * direction + along * normal} (Snell's law).
     *
     * @param cosine as above, without total internal reflection
     */
    static float along(float cosine, float ratio) {
        return ratio * cosine - (float) Math.sqrt(Math.max(passedSquared(cosine, ratio), 0f));
    }

    /** The square of the refracted ray's cosine, 0 or less where there is none; flat rays keep their digits. */
    private static float passedSquared(float cosine, float ratio) {
        return (1f - ratio) * (1f + ratio) + ratio * cosine * (ratio * cosine);
    }
}
