package dev.twister.kernel;

/**
 * The sheen of cloth: fibers at a right angle to the surface (Estevez and Kulla, "Production Friendly Microfacet Sheen
 * BRDF", 2017), as glTF's {@code KHR_materials_sheen} has it, but never more light than there is.
 */
public final class Sheen {
    /** The squared roughness is at least the inverse of the largest exponent. */
    public static final float LEAST_ALPHA = 1f / KernelMath.MOST_EXPONENT;

    /**
     * The fit of the fibers' mutual shadowing, {@code a / (1 + b x^c) + d x + e}, at squared roughness 1, and the
     * difference to that at 0.
     */
    public static final float A = 21.5473f;

    public static final float B = 3.82987f;
    public static final float C = 0.19823f;
    public static final float D = -1.97760f;
    public static final float E = -4.32054f;
    public static final float MORE_A = 3.7772f;
    public static final float MORE_B = -0.50552f;
    public static final float MORE_C = -0.03022f;
    public static final float MORE_D = 0.70367f;
    public static final float MORE_E = -0.53913f;

    private static final float INVERSE_E = 0.36787945f;
    private static final float LEAST_COSINE = 1e-4f;

    private Sheen() {}

    /** The part of white light from the ray's origin that a white sheen reflects. */
    static float albedo(float[] path, float[] looks) {
        float cosine = Math.min(Math.max(-Facet.directionDot(path, Layout.NORMAL), 0f), 1f);
        return fromTable(path, 0, cosine, looks);
    }

    /** @param table 0 for the albedo, 1 for what divides the reflectance so that the albedo is at most 1 */
    private static float fromTable(float[] path, int table, float cosine, float[] looks) {
        int place = (int) path[Layout.SHEEN_TABLE] + table * DirectionalAlbedo.TABLE_LENGTH;
        return DirectionalAlbedo.of(place, path[Layout.FINISH + Layout.FINISH_SHEEN_ROUGHNESS], cosine, looks);
    }

    /** The reflectance of a white sheen per steradian, for a direction above the surface. */
    static float evaluate(float[] path, float x, float y, float z, float cosineOut, float[] looks) {
        float halfX = x - path[Layout.DIRECTION];
        float halfY = y - path[Layout.DIRECTION + 1];
        float halfZ = z - path[Layout.DIRECTION + 2];
        float inverse = KernelMath.inverseRoot(halfX * halfX + halfY * halfY + halfZ * halfZ);
        float half = halfX * path[Layout.NORMAL] + halfY * path[Layout.NORMAL + 1] + halfZ * path[Layout.NORMAL + 2];
        float in = Math.min(Math.max(-Facet.directionDot(path, Layout.NORMAL), LEAST_COSINE), 1f);
        float out = Math.min(Math.max(cosineOut, LEAST_COSINE), 1f);
        float most = fromTable(path, 1, in, looks) * fromTable(path, 1, out, looks);
        return reflectance(path[Layout.FINISH + Layout.FINISH_SHEEN_ROUGHNESS], in, out, half * inverse) / most;
    }

    /**
     * The reflectance per steradian, which may be more than all at grazing angles.
     *
     * @param cosineIn of one direction, in (0, 1]
     * @param cosineOut of the other, in (0, 1]
     * @param cosine of the direction halfway between them
     */
    private static float reflectance(float roughness, float cosineIn, float cosineOut, float cosine) {
        float alpha = Math.max(roughness * roughness, LEAST_ALPHA);
        float sine = (float) Math.sqrt(Math.min(Math.max(1f - cosine * cosine, 0f), 1f));
        float fibers = (2f + 1f / alpha) * KernelMath.pow(sine, 1f / alpha) / (2f * KernelMath.PI);
        return fibers / (4f * cosineIn * cosineOut * (1f + lambda(alpha, cosineIn) + lambda(alpha, cosineOut)));
    }

    private static float lambda(float alpha, float cosine) {
        int steep = cosine < 0.5f ? 1 : 0;
        float fitted = fitted(alpha, steep != 0 ? cosine : 1f - cosine);
        float exponent = steep != 0 ? fitted : 2f * fitted(alpha, 0.5f) - fitted;
        float power = KernelMath.pow(INVERSE_E, Math.abs(exponent));
        return exponent > 0f ? 1f / power : power;
    }

    private static float fitted(float alpha, float x) {
        float more = (1f - alpha) * (1f - alpha);
        float a = A + more * MORE_A;
        float b = B + more * MORE_B;
        float c = C + more * MORE_C;
        return a / (1f + b * KernelMath.pow(x, c)) + (D + more * MORE_D) * x + (E + more * MORE_E);
    }
}
