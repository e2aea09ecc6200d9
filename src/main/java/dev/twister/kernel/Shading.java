package dev.twister.kernel;

/** Blinn-Phong, as the design has it: {@code shade(C) = C * lit + lightColor * spec}. */
public final class Shading {
    /** {@code 1 / (8 pi)}. */
    public static final float INVERSE_EIGHT_PI = 0.039788734f;

    private Shading() {}

    /** {@code max(a, max(0, N.L) * S)}. */
    public static float lit(float ambient, float normalDotLight, float visible) {
        return (normalDotLight * visible > ambient ? normalDotLight * visible : ambient);
    }

    /**
     * {@code S * (8 + p) / (8 pi) * max(0, N.H)^p * p / 128} where the light is in front, else 0. H is the unit vector
     * of L + V; where L and V cancel, it is 0.
     *
     * @param halfLengthSquared of L + V
     * @param normalDotHalf N.(L + V), not yet divided by the length
     */
    public static float specular(
            float reflectivity, float normalDotLight, float normalDotHalf, float halfLengthSquared, float visible) {
        float specular = 0f;
        if (normalDotLight > 0f) {
            float cosine = halfCosine(normalDotHalf, halfLengthSquared);
            specular = specular(reflectivity, KernelMath.pow(cosine, reflectivity), visible);
        }
        return specular;
    }

    /** {@code max(0, N.H)}, of the same arguments. */
    static float halfCosine(float normalDotHalf, float halfLengthSquared) {
        return Math.min(Math.max(0f, normalDotHalf * KernelMath.inverseRoot(halfLengthSquared)), 1f);
    }

    /** {@code S * (8 + p) / (8 pi) * power * p / 128}, where the power is that of {@code max(0, N.H)}. */
    static float specular(float reflectivity, float power, float visible) {
        return visible * (8f + reflectivity) * INVERSE_EIGHT_PI * power * reflectivity / Layout.MAX_REFLECTIVITY;
    }

    /** 1 where {@code floor(x) + floor(z)} is even (the plane's first colour), else 0. */
    public static int isEvenSquare(float x, float z) {
        return 1 - ((KernelMath.floor(x) + KernelMath.floor(z)) & 1);
    }
}
