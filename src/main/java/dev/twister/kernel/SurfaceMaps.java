package dev.twister.kernel;

/** Maps and vertex colors, which vary a body's material over its surface. Only with {@link Variant#MAPS}. */
final class SurfaceMaps {
    private SurfaceMaps() {}

    /**
     * Applies all but the normal map to the material at {@link Layout#POINT}, and writes {@link Layout#EMISSION},
     * {@link Layout#PASSING} and {@link Layout#OCCLUSION}.
     *
     * @param path {@link Layout#PATH_LENGTH} floats, after {@link SurfaceLook#find}
     */
    static void find(
            float[] path,
            int body,
            float[] frame,
            float[] bodies,
            float[] looks,
            float[] meshes,
            float[] images,
            int variant) {
        int look = Layout.LOOK_STRIDE * body;
        int maps = (int) looks[look + Layout.LOOK_MAPS];
        int row = row(maps, frame);
        path[Layout.OCCLUSION] = 1f;
        for (int channel = 0; channel < 3; channel++) {
            path[Layout.EMISSION + channel] = looks[look + Layout.LOOK_EMISSION + channel];
        }
        if (maps > 0) {
            if (looks[row + Layout.MAPS_VERTEX_COLORS] > 0f) {
                multiplyByVertexColor(path, frame, bodies, meshes);
            }
            // A loop, so that the code that reads a map is there once.
            for (int place = Layout.MAPS_COLOR; place < Layout.MAPS_ALPHA; place += Layout.MAP_STRIDE) {
                if (aim(path, row + place, body, frame, bodies, looks, meshes, variant) != 0) {
                    multiply(path, row, place, looks, images);
                }
            }
            derive(path, row, looks, variant);
        }
        path[Layout.PASSING] = path[Layout.ALBEDO];
        path[Layout.PASSING + 1] = path[Layout.ALBEDO + 1];
        path[Layout.PASSING + 2] = path[Layout.ALBEDO + 2];
        if ((variant & Variant.MASKS) != 0) {
            if ((variant & Variant.PATH) == 0) {
                Opacity.blend(path, body, frame, bodies, looks, meshes);
            }
        }
    }

    /** Place in {@code looks} of a row of the maps' table. */
    static int row(int maps, float[] frame) {
        return (int) frame[Layout.MAPS] + Layout.MAPS_STRIDE * (maps - 1);
    }

    /** Writes {@link Layout#TEXEL} and returns 1, or returns 0 if there is no such map. */
    static int aim(
            float[] path,
            int map,
            int body,
            float[] frame,
            float[] bodies,
            float[] looks,
            float[] meshes,
            int variant) {
        int exists = looks[map + Layout.MAP_WIDTH] > 0f ? 1 : 0;
        if (exists != 0) {
            if (Surface.isMesh(body, frame, variant) != 0) {
                int set = (int) looks[map + Layout.MAP_SAMPLER] / Layout.SAMPLER_COORDINATES;
                int instance = Instance.at((int) path[Layout.INSTANCE], (int) frame[Layout.INSTANCES], bodies);
                int triangle =
                        Instance.triangles(bodies, instance) + Layout.TRIANGLE_STRIDE * (int) path[Layout.TRIANGLE];
                float b = path[Layout.CORNER_PARTS];
                float c = path[Layout.CORNER_PARTS + 1];
                MeshSurface.writeTexturePlace(path, instance, triangle, set, b, c, bodies, meshes);
            }
            Texture.aim(path, map, body, frame, looks, variant);
        }
        return exists;
    }

    /**
     * Multiplies what a map varies by its color at {@link Layout#TEXEL}.
     *
     * @param row place of the body's maps in {@code looks}
     * @param place of the map in the row
     */
    private static void multiply(float[] path, int row, int place, float[] looks, float[] images) {
        float red = Texture.channel(path, row + place, 0, looks, images);
        float green = Texture.channel(path, row + place, 1, looks, images);
        float blue = Texture.channel(path, row + place, 2, looks, images);
        int color = place == Layout.MAPS_COLOR ? 1 : 0;
        path[Layout.ALBEDO] = path[Layout.ALBEDO] * (color != 0 ? red : 1f);
        path[Layout.ALBEDO + 1] = path[Layout.ALBEDO + 1] * (color != 0 ? green : 1f);
        path[Layout.ALBEDO + 2] = path[Layout.ALBEDO + 2] * (color != 0 ? blue : 1f);
        int emission = place == Layout.MAPS_EMISSION ? 1 : 0;
        path[Layout.EMISSION] = path[Layout.EMISSION] * (emission != 0 ? red : 1f);
        path[Layout.EMISSION + 1] = path[Layout.EMISSION + 1] * (emission != 0 ? green : 1f);
        path[Layout.EMISSION + 2] = path[Layout.EMISSION + 2] * (emission != 0 ? blue : 1f);
        path[Layout.ROUGHNESS] = path[Layout.ROUGHNESS] * (place == Layout.MAPS_ROUGHNESS ? green : 1f);
        path[Layout.METALLIC] = path[Layout.METALLIC] * (place == Layout.MAPS_METALLIC ? blue : 1f);
        path[Layout.TRANSMISSION] = path[Layout.TRANSMISSION] * (place == Layout.MAPS_TRANSMISSION ? red : 1f);
        float open = 1f + looks[row + Layout.MAPS_OCCLUSION_STRENGTH] * (red - 1f);
        path[Layout.OCCLUSION] = path[Layout.OCCLUSION] * (place == Layout.MAPS_OCCLUSION ? open : 1f);
    }

    private static void multiplyByVertexColor(float[] path, float[] frame, float[] bodies, float[] meshes) {
        int instance = Instance.at((int) path[Layout.INSTANCE], (int) frame[Layout.INSTANCES], bodies);
        int triangle = Instance.triangles(bodies, instance) + Layout.TRIANGLE_STRIDE * (int) path[Layout.TRIANGLE];
        float b = path[Layout.CORNER_PARTS];
        float c = path[Layout.CORNER_PARTS + 1];
        for (int channel = 0; channel < 3; channel++) {
            path[Layout.ALBEDO + channel] =
                    path[Layout.ALBEDO + channel] * vertexColor(instance, triangle, channel, b, c, bodies, meshes);
        }
    }

    /**
     * One channel of the vertex colors, interpolated between a triangle's corners.
     *
     * @param channel 0 red, 1 green, 2 blue, 3 opacity
     */
    static float vertexColor(
            int instance, int triangle, int channel, float b, float c, float[] bodies, float[] meshes) {
        int first = Instance.colors(bodies, instance) + channel;
        float atA = meshes[first + 4 * (int) meshes[triangle + Layout.TRIANGLE_VERTICES]];
        float atB = meshes[first + 4 * (int) meshes[triangle + Layout.TRIANGLE_VERTICES + 1]];
        float atC = meshes[first + 4 * (int) meshes[triangle + Layout.TRIANGLE_VERTICES + 2]];
        return atA + b * (atB - atA) + c * (atC - atA);
    }

    /** What follows from the mapped properties: a glTF material's reflectivity; an unlit surface's color is emitted. */
    private static void derive(float[] path, int row, float[] looks, int variant) {
        float metallic = path[Layout.METALLIC];
        // As Material.whittedReflectivity has it; path tracing takes the reflectivity of other materials alone.
        int derived = (path[Layout.IS_FRESNEL] > 0f ? 1 : 0)
                & ((metallic > 0f ? 1 : 0) | (path[Layout.TRANSMISSION] > 0f ? 0 : 1));
        path[Layout.REFLECTIVITY] =
                derived != 0 ? (5f + 91f * metallic) * (1f - path[Layout.ROUGHNESS]) : path[Layout.REFLECTIVITY];
        if ((variant & Variant.PATH) == 0) {
            float metal = path[Layout.IS_FRESNEL] < 0f ? 96f * metallic * (1f - path[Layout.ROUGHNESS]) : 0f;
            path[Layout.REFLECTIVITY] = Math.max(path[Layout.REFLECTIVITY], metal);
        }
        if (looks[row + Layout.MAPS_UNLIT] > 0f) {
            for (int channel = 0; channel < 3; channel++) {
                path[Layout.EMISSION + channel] = path[Layout.ALBEDO + channel];
                path[Layout.ALBEDO + channel] = 0f;
            }
            path[Layout.REFLECTIVITY] = 0f;
            path[Layout.METALLIC] = 0f;
            path[Layout.IS_FRESNEL] = 0f;
        }
    }
}
