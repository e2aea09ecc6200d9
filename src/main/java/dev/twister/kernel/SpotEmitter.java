package dev.twister.kernel;

/**
 * A spot: a sphere whose radiance fades out toward the border of a cone of directions, as in glTF's
 * KHR_lights_punctual: {@code clamp(cos * scale + offset, 0, 1)^2} of the angle with the spot's axis. Its directions
 * are chosen as those of a {@link SphereEmitter}.
 */
public final class SpotEmitter {
    private SpotEmitter() {}

    /** Multiplies {@link Layout#EMITTED} by {@link #part} toward the chosen point. */
    static void dim(float[] path, int body, float[] looks) {
        float part = part(path, Layout.TO_LIGHT, body, looks);
        path[Layout.EMITTED] = path[Layout.EMITTED] * part;
        path[Layout.EMITTED + 1] = path[Layout.EMITTED + 1] * part;
        path[Layout.EMITTED + 2] = path[Layout.EMITTED + 2] * part;
    }

    /** 1 if the body is a spot that emits nothing against the path's ray, so that the ray passes it, else 0. */
    public static int isDark(float[] path, int body, float[] looks) {
        int dark = 0;
        if (looks[Layout.LOOK_STRIDE * body + Layout.LOOK_LIGHT] == Layout.SPOT_LIGHT) {
            dark = part(path, Layout.DIRECTION, body, looks) > 0f ? 0 : 1;
        }
        return dark;
    }

    /**
     * The part of a spot's radiance, in [0, 1], that it emits against a direction; 1 for other bodies.
     *
     * @param toward place in the path of the unit vector toward the spot
     */
    public static float part(float[] path, int toward, int body, float[] looks) {
        int look = Layout.LOOK_STRIDE * body;
        float cosine = -(looks[look + Layout.LOOK_SPOT_AXIS] * path[toward]
                + looks[look + Layout.LOOK_SPOT_AXIS + 1] * path[toward + 1]
                + looks[look + Layout.LOOK_SPOT_AXIS + 2] * path[toward + 2]);
        float scaled = cosine * looks[look + Layout.LOOK_SPOT_SCALE] + looks[look + Layout.LOOK_SPOT_OFFSET];
        float root = Math.min(Math.max(scaled, 0f), 1f);
        return looks[look + Layout.LOOK_LIGHT] == Layout.SPOT_LIGHT ? root * root : 1f;
    }
}
