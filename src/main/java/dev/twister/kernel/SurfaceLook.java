package dev.twister.kernel;

/** A body's material at a point of its surface. */
public final class SurfaceLook {
    /** Shift of the checker in meters, so that no edge is at a round number, where rounding alone would decide. */
    public static final float CHECKER_SHIFT = 0x1p-10f;

    private SurfaceLook() {}

    /**
     * Writes the body's material at {@link Layout#POINT}; for plain materials only albedo and reflectivity.
     *
     * @param path {@link Layout#PATH_LENGTH} floats
     * @param body any except the light
     */
    public static void find(float[] path, int body, float[] frame, float[] looks, float[] images, int variant) {
        int look = Layout.LOOK_STRIDE * body;
        float red = looks[look];
        float green = looks[look + 1];
        float blue = looks[look + 2];
        if (body == Layout.PLANE) {
            int even = isEvenSquare(path[Layout.POINT], path[Layout.POINT + 2]);
            red = even != 0 ? red : frame[Layout.PLANE_ODD_COLOR];
            green = even != 0 ? green : frame[Layout.PLANE_ODD_COLOR + 1];
            blue = even != 0 ? blue : frame[Layout.PLANE_ODD_COLOR + 2];
        }
        path[Layout.ALBEDO] = red;
        path[Layout.ALBEDO + 1] = green;
        path[Layout.ALBEDO + 2] = blue;
        path[Layout.REFLECTIVITY] = looks[look + Layout.LOOK_REFLECTIVITY];
        if ((variant & Variant.MATERIALS) != 0) {
            path[Layout.ROUGHNESS] = looks[look + Layout.LOOK_ROUGHNESS];
            path[Layout.TRANSMISSION] = looks[look + Layout.LOOK_TRANSMISSION];
            path[Layout.IOR] = looks[look + Layout.LOOK_IOR];
            path[Layout.IS_SHEET] =
                    body == Layout.PLANE ? Layout.SHEET_WITHOUT_INSIDE : looks[look + Layout.LOOK_SHEET];
            path[Layout.METALLIC] = looks[look + Layout.LOOK_METALLIC];
            float fresnel = looks[look + Layout.LOOK_FRESNEL];
            path[Layout.IS_FRESNEL] = fresnel;
            // With maps, what is without path tracing follows from them.
            int beside = (fresnel < 0f ? 1 : 0) & ((variant & (Variant.PATH | Variant.MAPS)) != 0 ? 1 : 0);
            path[Layout.REFLECTIVITY] =
                    beside != 0 ? looks[look + Layout.LOOK_BESIDE_METAL] : path[Layout.REFLECTIVITY];
            if ((variant & Variant.PATH) != 0) {
                path[Layout.SPECULAR_LOSS] = looks[look + Layout.LOOK_SPECULAR_LOSS];
            }
            if ((variant & Variant.FINISH) != 0) {
                path[Layout.IS_FINISHED] = looks[look + Layout.LOOK_FINISH] > 0f ? 1f : 0f;
            }
            if ((variant & Variant.MAPS) == 0) {
                multiplyByTexture(path, body, frame, looks, images, variant);
            }
            for (int channel = 0; channel < 3; channel++) {
                path[Layout.PASSING + channel] = path[Layout.ALBEDO + channel];
            }
        }
    }

    private static void multiplyByTexture(
            float[] path, int body, float[] frame, float[] looks, float[] images, int variant) {
        int maps = (int) looks[Layout.LOOK_STRIDE * body + Layout.LOOK_MAPS];
        if (maps > 0) {
            int map = (int) frame[Layout.MAPS] + Layout.MAPS_STRIDE * (maps - 1) + Layout.MAPS_COLOR;
            Texture.aim(path, map, body, frame, looks, variant);
            for (int channel = 0; channel < 3; channel++) {
                path[Layout.ALBEDO + channel] =
                        path[Layout.ALBEDO + channel] * Texture.channel(path, map, channel, looks, images);
            }
        }
    }

    /**
     * 1 if {@code floor(x + s) + floor(z + s)} is even (the plane's first color), else 0, with s =
     * {@link #CHECKER_SHIFT}.
     */
    public static int isEvenSquare(float x, float z) {
        return 1 - ((KernelMath.floor(x + CHECKER_SHIFT) + KernelMath.floor(z + CHECKER_SHIFT)) & 1);
    }
}
