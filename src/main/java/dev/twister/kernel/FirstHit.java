package dev.twister.kernel;

/** Stages and views that are known at the first hit; {@link Aspect} defines their values. */
final class FirstHit {
    private FirstHit() {}

    /**
     * Adds the value of the path's view ray to {@link Layout#RADIANCE}. {@link Layout} describes the arrays.
     *
     * @param path {@link Layout#PATH_LENGTH} floats
     * @param bodies number of bodies
     * @param scratch {@link Layout#SCRATCH_LENGTH} floats
     * @param search {@link Hit#ALL} or {@link Hit#WALK}
     * @param firstMesh the first mesh's body, or {@link Layout#NO_MESHES}
     * @param materials {@link Material#PLAIN} or {@link Material#ANY}
     * @param aspect a constant of {@link Aspect} that ends at the first hit
     */
    static void add(
            float[] path,
            float[] properties,
            float[] places,
            float[] looks,
            float[] hierarchy,
            float[] meshes,
            int bodies,
            float[] sky,
            int[] skyDimensions,
            float[] shadowDisc,
            float[] scratch,
            int search,
            int firstMesh,
            int materials,
            int aspect) {
        int body =
                Hit.find(path, places, looks, hierarchy, meshes, bodies, scratch, search, firstMesh, materials, aspect);
        int sees = (body == Layout.NOTHING ? 1 : 0) & (aspect <= Aspect.HIGHLIGHTS ? 1 : 0);
        if (sees != 0) {
            Sky.add(path, sky, skyDimensions, properties);
        }
        float number = 0f;
        number = aspect == Aspect.BODY ? body : number;
        number = aspect == Aspect.SHADOW ? 1f : number;
        float red = number;
        float green = number;
        float blue = number;
        if (body >= Layout.LIGHT) {
            Path.meet(
                    path, body, properties, places, looks, hierarchy, meshes, sky, skyDimensions, firstMesh, materials);
            float lit = 1f;
            float specular = 0f;
            if (body >= Layout.PLANE) {
                int shaded = (aspect == Aspect.DIFFUSE ? 1 : 0) | (aspect == Aspect.HIGHLIGHTS ? 1 : 0);
                lit = shaded != 0 ? Light.lit(properties[Layout.AMBIENT], path[Layout.NORMAL_DOT_LIGHT], 1f) : 1f;
                if (aspect == Aspect.HIGHLIGHTS) {
                    specular = Light.highlight(path, 1f);
                }
                if (aspect == Aspect.SHADOW) {
                    number = Shadow.visible(
                            path,
                            body,
                            properties,
                            places,
                            looks,
                            shadowDisc,
                            hierarchy,
                            Layout.root(bodies),
                            meshes,
                            scratch,
                            firstMesh,
                            materials,
                            aspect);
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
