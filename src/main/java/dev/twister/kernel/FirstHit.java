package dev.twister.kernel;

/** Stages and views that are known at the first hit; {@link Aspect} defines their values. */
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
        int aspect = Variant.aspect(variant);
        int body = Hit.find(path, scratch, frame, bodies, looks, meshes, variant);
        int sees = (body == Layout.NOTHING ? 1 : 0) & (aspect <= Aspect.HIGHLIGHTS ? 1 : 0);
        if (sees != 0) {
            SkyLookup.add(path, frame, images);
        }
        float number = 0f;
        number = aspect == Aspect.BODY ? body : number;
        number = aspect == Aspect.SHADOW ? 1f : number;
        float red = number;
        float green = number;
        float blue = number;
        if (body >= Layout.LIGHT) {
            Path.meet(path, body, frame, bodies, looks, meshes, images, variant);
            float lit = 1f;
            float specular = 0f;
            if (body >= Layout.PLANE) {
                int shaded = (aspect == Aspect.DIFFUSE ? 1 : 0) | (aspect == Aspect.HIGHLIGHTS ? 1 : 0);
                lit = shaded != 0 ? Illumination.lit(frame[Layout.AMBIENT], path[Layout.NORMAL_DOT_LIGHT], 1f) : 1f;
                if (aspect == Aspect.HIGHLIGHTS) {
                    specular = Illumination.highlight(path, 1f);
                }
                if (aspect == Aspect.SHADOW) {
                    number = Shadow.visible(path, body, scratch, frame, bodies, looks, meshes, variant);
                }
            }
            number = aspect == Aspect.DEPTH ? path[Layout.DISTANCE] : number;
            int light = Layout.LOOK_STRIDE * Layout.LIGHT;
            red = path[Layout.ALBEDO] * lit + looks[light] * specular;
            green = path[Layout.ALBEDO + 1] * lit + looks[light + 1] * specular;
            blue = path[Layout.ALBEDO + 2] * lit + looks[light + 2] * specular;
            if (aspect == Aspect.NORMAL) {
                red = 0.5f + 0.5f * path[Layout.NORMAL];
                green = 0.5f + 0.5f * path[Layout.NORMAL + 1];
                blue = 0.5f + 0.5f * path[Layout.NORMAL + 2];
            }
            red = aspect > Aspect.NORMAL ? number : red;
            green = aspect > Aspect.NORMAL ? number : green;
            blue = aspect > Aspect.NORMAL ? number : blue;
        }
        path[Layout.RADIANCE] = path[Layout.RADIANCE] + red;
        path[Layout.RADIANCE + 1] = path[Layout.RADIANCE + 1] + green;
        path[Layout.RADIANCE + 2] = path[Layout.RADIANCE + 2] + blue;
    }
}
