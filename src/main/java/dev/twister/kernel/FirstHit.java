package dev.twister.kernel;

/** Stages and views that are known at the first hit; {@link Views} defines their values. */
final class FirstHit {
    private FirstHit() {}

    /**
     * Adds the value of the path's view ray to {@link Layout#RADIANCE}. {@link Layout} describes the arrays.
     *
     * @param path {@link Layout#PATH_LENGTH} floats
     * @param scratch {@link Layout#SCRATCH_LENGTH} floats
     */
    static void add(
            float[] path,
            float[] scratch,
            float[] frame,
            float[] bodies,
            float[] looks,
            float[] meshes,
            float[] images,
            int variant) {
        int stageOrView = Variant.stageOrView(variant);
        int body = Hit.find(path, scratch, frame, bodies, looks, meshes, variant);
        int sees = (body == Layout.NOTHING ? 1 : 0) & (stageOrView <= Views.HIGHLIGHTS ? 1 : 0);
        if (sees != 0) {
            SkyLookup.add(path, frame, images);
        }
        float number = 0f;
        number = stageOrView == Views.BODY ? body : number;
        number = stageOrView == Views.SHADOW ? 1f : number;
        float red = number;
        float green = number;
        float blue = number;
        if (body >= Layout.LIGHT) {
            Path.meet(path, body, frame, bodies, looks, meshes, images, variant);
            float lit = 1f;
            float specular = 0f;
            int isSurface = (body >= Layout.PLANE ? 1 : 0) & (1 - Surface.isLight(body, looks, variant));
            if (isSurface != 0) {
                int shaded = (stageOrView == Views.DIFFUSE ? 1 : 0) | (stageOrView == Views.HIGHLIGHTS ? 1 : 0);
                if (shaded != 0) {
                    lit = lit(path, body, scratch, frame, bodies, looks, meshes, variant);
                }
                if (stageOrView == Views.HIGHLIGHTS) {
                    specular = (variant & Variant.LIGHTS) != 0 ? 1f : Illumination.highlight(path, 1f);
                }
                if (stageOrView == Views.SHADOW) {
                    number = visible(path, body, scratch, frame, bodies, looks, meshes, variant);
                }
            }
            number = stageOrView == Views.DEPTH ? path[Layout.DISTANCE] : number;
            red = path[Layout.ALBEDO] * lit;
            green = path[Layout.ALBEDO + 1] * lit;
            blue = path[Layout.ALBEDO + 2] * lit;
            if (specular > 0f) {
                red = red + Scatter.highlight(path, 0, looks, variant) * specular;
                green = green + Scatter.highlight(path, 1, looks, variant) * specular;
                blue = blue + Scatter.highlight(path, 2, looks, variant) * specular;
            }
            if (stageOrView == Views.NORMAL) {
                red = 0.5f + 0.5f * path[Layout.NORMAL];
                green = 0.5f + 0.5f * path[Layout.NORMAL + 1];
                blue = 0.5f + 0.5f * path[Layout.NORMAL + 2];
            }
            red = stageOrView > Views.NORMAL ? number : red;
            green = stageOrView > Views.NORMAL ? number : green;
            blue = stageOrView > Views.NORMAL ? number : blue;
        }
        path[Layout.RADIANCE] = path[Layout.RADIANCE] + red;
        path[Layout.RADIANCE + 1] = path[Layout.RADIANCE + 1] + green;
        path[Layout.RADIANCE + 2] = path[Layout.RADIANCE + 2] + blue;
    }

    /** Without shadows; with several lights the path gets the sum of the highlights. */
    private static float lit(
            float[] path,
            int body,
            float[] scratch,
            float[] frame,
            float[] bodies,
            float[] looks,
            float[] meshes,
            int variant) {
        float lit = 1f;
        if ((variant & Variant.LIGHTS) != 0) {
            lit = SeveralLights.shade(path, body, 0, scratch, frame, bodies, looks, meshes, variant);
        } else {
            lit = Illumination.lit(Illumination.ambient(path, frame, variant), path[Layout.NORMAL_DOT_LIGHT], 1f);
        }
        return lit;
    }

    private static float visible(
            float[] path,
            int body,
            float[] scratch,
            float[] frame,
            float[] bodies,
            float[] looks,
            float[] meshes,
            int variant) {
        float visible = 1f;
        if ((variant & Variant.LIGHTS) != 0) {
            visible = SeveralLights.visible(path, body, scratch, frame, bodies, looks, meshes, variant);
        } else {
            visible = Shadow.visible(path, body, scratch, frame, bodies, looks, meshes, variant);
        }
        return visible;
    }
}
