package dev.twister.kernel;

/** Reflectance and direction at the boundary of two media. */
public final class Refraction {
    private Refraction() {}

    /**
     * The unpolarized Fresnel reflectance of a dielectric, in [0, 1]; 1 at total internal reflection.
     *
     * @param cosine cosine between the reversed ray and the facet's normal, in [0, 1]
     * @param ratio index of refraction on the ray's side divided by that on the other side
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
     * The coefficient of the normal in the refracted ray {@code ratio * direction + along * normal} (Snell's law).
     *
     * @param cosine as above, without total internal reflection
     */
    static float along(float cosine, float ratio) {
        return ratio * cosine - (float) Math.sqrt(Math.max(passedSquared(cosine, ratio), 0f));
    }

    /**
     * The squared cosine of the refracted ray, 0 or negative at total internal reflection; accurate at grazing angles.
     */
    static float passedSquared(float cosine, float ratio) {
        return (1f - ratio) * (1f + ratio) + ratio * cosine * (ratio * cosine);
    }
}
