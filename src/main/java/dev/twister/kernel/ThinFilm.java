package dev.twister.kernel;

/**
 * Interference in a thin film over a surface (Belcour and Barla, "A Practical Extension to Microfacet Theory for the
 * Modeling of Varying Iridescence", 2017), as glTF's {@code KHR_materials_iridescence} approximates it.
 */
final class ThinFilm {
    private static final float INVERSE_E = 0.36787945f;

    /** Up to this thickness in nanometers the film's index fades in, so that no film is nothing. */
    private static final float FADE = 0.03f;

    /** Gaussians of the CIE's color matching functions: the value, the place in 1 / m, and the variance. */
    private static final float X_VALUE = 5.4856e-13f;

    private static final float Y_VALUE = 4.4201e-13f;
    private static final float Z_VALUE = 5.2481e-13f;
    private static final float X_SECOND_VALUE = 9.7470e-14f;
    private static final float X_PLACE = 1.6810e6f;
    private static final float Y_PLACE = 1.7953e6f;
    private static final float Z_PLACE = 2.2084e6f;
    private static final float X_SECOND_PLACE = 2.2399e6f;
    private static final float X_VARIANCE = 4.3278e9f;
    private static final float Y_VARIANCE = 9.3046e9f;
    private static final float Z_VARIANCE = 6.6121e9f;
    private static final float X_SECOND_VARIANCE = 4.5282e9f;
    private static final float WHITE = 1.0685e-7f;

    private static final float NANOMETER = 1e-9f;
    private static final float LEAST = 1e-5f;
    private static final float MOST = 0.9999f;

    private ThinFilm() {}

    /**
     * The reflectance of one channel.
     *
     * @param path with the film's index of refraction and thickness
     * @param cosine between the facet and the direction outside, in [0, 1]
     * @param straight what the surface below reflects at its normal, in [0, 1]
     */
    static float reflectance(float[] path, int channel, float cosine, float straight) {
        float thickness = path[Layout.FINISH + Layout.FINISH_FILM_THICKNESS];
        float faded = Math.min(Math.max(thickness / FADE, 0f), 1f);
        float index = 1f + (path[Layout.FINISH + Layout.FINISH_FILM_IOR] - 1f) * faded * faded * (3f - 2f * faded);
        float inside = 1f - (1f - cosine * cosine) / (index * index);
        float cosineInside = (float) Math.sqrt(Math.min(Math.max(inside, 0f), 1f));
        float outer = Refraction.reflectance(cosine, 1f / index);
        float passed = 1f - outer;
        float root = (float) Math.sqrt(Math.min(straight, MOST));
        float below = (1f + root) / Math.max(1f - root, LEAST);
        float inner = schlick(straight(index, below), cosineInside);
        float shift = below < index ? 1f : 0.5f;
        float path2 = 2f * index * thickness * cosineInside;
        float both = Math.min(outer * inner, MOST);
        float bounced = passed * passed * inner / (1f - both);
        float amplitude = (float) Math.sqrt(both);
        float first = (bounced - passed) * amplitude;
        float second = first * amplitude;
        float sum = outer
                + bounced
                + 2f * first * sensitivity(channel, path2, shift)
                + 2f * second * sensitivity(channel, 2f * path2, 2f * shift);
        return Math.min(Math.max(sum, 0f), 1f);
    }

    /** The reflectance at the normal of the boundary of two indices of refraction. */
    private static float straight(float from, float to) {
        float root = (to - from) / (to + from);
        return root * root;
    }

    private static float schlick(float straight, float cosine) {
        float away = 1f - cosine;
        return straight + (1f - straight) * away * away * away * away * away;
    }

    /**
     * What one channel of linear sRGB sees of light that interferes.
     *
     * @param difference of the ways, in nanometers
     * @param shift of the phase, in turns
     */
    private static float sensitivity(int channel, float difference, float shift) {
        float x = seen(difference, shift, X_VALUE, X_PLACE, X_VARIANCE)
                + seen(difference, shift, X_SECOND_VALUE, X_SECOND_PLACE, X_SECOND_VARIANCE);
        float y = seen(difference, shift, Y_VALUE, Y_PLACE, Y_VARIANCE);
        float z = seen(difference, shift, Z_VALUE, Z_PLACE, Z_VARIANCE);
        float red = 3.2404542f * x - 1.5371385f * y - 0.4985314f * z;
        float green = -0.9692660f * x + 1.8760108f * y + 0.0415560f * z;
        float blue = 0.0556434f * x - 0.2040259f * y + 1.0572252f * z;
        return (channel == 0 ? red : channel == 1 ? green : blue) / WHITE;
    }

    private static float seen(float difference, float shift, float value, float place, float variance) {
        float turns = place * NANOMETER * difference + shift;
        float phase = 2f * KernelMath.PI * NANOMETER * difference;
        float exponent = Math.min(variance * phase * phase, KernelMath.MOST_EXPONENT);
        float width = (float) Math.sqrt(2f * KernelMath.PI * variance);
        return value
                * width
                * KernelMath.cosineOfTurns(turns - KernelMath.floor(turns))
                * KernelMath.pow(INVERSE_E, exponent);
    }
}
