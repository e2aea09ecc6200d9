package dev.twister.kernel;

/** A light as a visible body and as illumination (Blinn-Phong, {@code shade(C) = C * lit + lightColor * spec}). */
public final class Illumination {
    /** {@code 1 / (8 pi)}. */
    public static final float INVERSE_EIGHT_PI = 0.039788734f;

    private Illumination() {}

    /** The body of the light that shades now: the only one, or {@link Layout#SHADING_LIGHT}. */
    static int shading(float[] path, int variant) {
        int light = Layout.LIGHT;
        if ((variant & Variant.LIGHTS) != 0) {
            light = (int) path[Layout.SHADING_LIGHT];
        }
        return light;
    }

    /**
     * Adds a light's own color if the path ends at it.
     *
     * @param path {@link Layout#PATH_LENGTH} floats
     * @param light its body
     */
    public static void add(float[] path, int light, float[] looks) {
        for (int channel = 0; channel < 3; channel++) {
            path[Layout.RADIANCE + channel] = path[Layout.RADIANCE + channel]
                    + path[Layout.THROUGHPUT + channel] * looks[Layout.LOOK_STRIDE * light + channel];
        }
    }

    /**
     * Writes the unit vector from {@link Layout#POINT} to a light's center, the distance in meters, and the cosine with
     * the normal.
     *
     * @param path {@link Layout#PATH_LENGTH} floats
     * @param light its body
     */
    public static void aim(float[] path, int light, float[] bodies) {
        int place = Layout.PLACE_STRIDE * light;
        aim(
                path,
                bodies[place] - path[Layout.POINT],
                bodies[place + 1] - path[Layout.POINT + 1],
                bodies[place + 2] - path[Layout.POINT + 2]);
    }

    /** As above, for a light of any kind: a sun is everywhere in the same direction. */
    public static void aimAtAny(float[] path, int light, float[] bodies, float[] looks) {
        aim(
                path,
                fromPoint(path, light, 0, bodies, looks),
                fromPoint(path, light, 1, bodies, looks),
                fromPoint(path, light, 2, bodies, looks));
    }

    private static float fromPoint(float[] path, int light, int axis, float[] bodies, float[] looks) {
        float place = bodies[Layout.PLACE_STRIDE * light + axis];
        return isSun(light, looks) != 0 ? place : place - path[Layout.POINT + axis];
    }

    /** 1 if the body is a sun, else 0. */
    static int isSun(int light, float[] looks) {
        return looks[Layout.LOOK_STRIDE * light + Layout.LOOK_LIGHT] == Layout.SUN_LIGHT ? 1 : 0;
    }

    /** One coordinate of the center of the light that shades {@link Layout#POINT}. */
    static float center(float[] path, int axis, float[] bodies, float[] looks, int variant) {
        int light = shading(path, variant);
        float center = bodies[Layout.PLACE_STRIDE * light + axis];
        if ((variant & Variant.LIGHTS) != 0) {
            center = isSun(light, looks) != 0 ? center + path[Layout.POINT + axis] : center;
        }
        return center;
    }

    /** Aims at what is so far away from {@link Layout#POINT}. */
    private static void aim(float[] path, float awayX, float awayY, float awayZ) {
        float x = awayX;
        float y = awayY;
        float z = awayZ;
        float distanceSquared = x * x + y * y + z * z;
        float inverse = KernelMath.inverseRoot(distanceSquared);
        x = x * inverse;
        y = y * inverse;
        z = z * inverse;
        path[Layout.TO_LIGHT] = x;
        path[Layout.TO_LIGHT + 1] = y;
        path[Layout.TO_LIGHT + 2] = z;
        path[Layout.LIGHT_DISTANCE] = distanceSquared * inverse;
        path[Layout.NORMAL_DOT_LIGHT] =
                path[Layout.NORMAL] * x + path[Layout.NORMAL + 1] * y + path[Layout.NORMAL + 2] * z;
    }

    /** a: the scene's, less where a map says that the surface is occluded. */
    public static float ambient(float[] path, float[] frame, int variant) {
        float ambient = frame[Layout.AMBIENT];
        if ((variant & Variant.MAPS) != 0) {
            ambient = ambient * path[Layout.OCCLUSION];
        }
        return ambient;
    }

    /** {@code max(a, max(0, N.L) * S)}. */
    public static float lit(float ambient, float normalDotLight, float visible) {
        return normalDotLight * visible > ambient ? normalDotLight * visible : ambient;
    }

    /** The highlight's strength at {@link Layout#POINT}: {@link #specular(float, float, float, float, float)}. */
    public static float highlight(float[] path, float visible) {
        float halfX = path[Layout.TO_LIGHT] - path[Layout.DIRECTION];
        float halfY = path[Layout.TO_LIGHT + 1] - path[Layout.DIRECTION + 1];
        float halfZ = path[Layout.TO_LIGHT + 2] - path[Layout.DIRECTION + 2];
        return specular(
                path[Layout.REFLECTIVITY],
                path[Layout.NORMAL_DOT_LIGHT],
                path[Layout.NORMAL] * halfX + path[Layout.NORMAL + 1] * halfY + path[Layout.NORMAL + 2] * halfZ,
                halfX * halfX + halfY * halfY + halfZ * halfZ,
                visible);
    }

    /**
     * {@code S * (8 + p) / (8 pi) * max(0, N.H)^p * p / 128} if the light is in front, else 0. H is the normalized L +
     * V; if L and V cancel out, it is 0.
     *
     * @param normalDotHalf N.(L + V), not divided by the length
     * @param halfLengthSquared squared length of L + V
     */
    public static float specular(
            float reflectivity, float normalDotLight, float normalDotHalf, float halfLengthSquared, float visible) {
        float specular = 0f;
        if (normalDotLight > 0f) {
            float cosine = Math.min(Math.max(0f, normalDotHalf * KernelMath.inverseRoot(halfLengthSquared)), 1f);
            specular = visible
                    * (8f + reflectivity)
                    * INVERSE_EIGHT_PI
                    * KernelMath.pow(cosine, reflectivity)
                    * reflectivity
                    / Layout.MAX_REFLECTIVITY;
        }
        return specular;
    }
}
