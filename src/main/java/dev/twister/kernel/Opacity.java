package dev.twister.kernel;

/**
 * Opacity of meshes. A mask cuts out what is less opaque than its cutoff. What is blended passes light in part; in path
 * tracing a ray goes through or not by chance. Only with {@link Variant#MASKS}.
 */
final class Opacity {
    private Opacity() {}

    /**
     * 1 if a ray goes through a triangle that it meets, else 0. Overwrites the path's texture coordinates.
     *
     * @param path with the ray of {@link MeshRay}
     * @param instance its place
     * @param number the triangle's number in the mesh
     */
    static int lets(
            float[] path,
            int body,
            int instance,
            int number,
            float[] frame,
            float[] bodies,
            float[] looks,
            float[] meshes,
            int variant) {
        int passes = 0;
        float least = cutoff(body, frame, looks);
        int chance = 0;
        if ((variant & Variant.PATH) != 0) {
            chance = least == Layout.BLENDED ? 1 : 0;
        }
        if (((least >= 0f ? 1 : 0) | chance) != 0) {
            float opacity = at(path, body, instance, number, frame, bodies, looks, meshes);
            float chosen = 0f;
            if (chance != 0) {
                chosen = Noise.crossing(path, body, number, frame);
            }
            passes = chance != 0 ? (opacity <= chosen ? 1 : 0) : (opacity < least ? 1 : 0);
        }
        return passes;
    }

    /** The part of a shadow ray's light in [0, 1] that goes through a triangle that it meets; for opaque bodies 0. */
    static float passed(
            float[] path,
            int body,
            int instance,
            int number,
            float[] frame,
            float[] bodies,
            float[] looks,
            float[] meshes) {
        float least = cutoff(body, frame, looks);
        float passed = 0f;
        if (least > Layout.OPAQUE) {
            float opacity = at(path, body, instance, number, frame, bodies, looks, meshes);
            float cut = opacity < least ? 1f : 0f;
            passed = least == Layout.BLENDED ? 1f - opacity : cut;
        }
        return passed;
    }

    /** A body's cutoff, {@link Layout#BLENDED} or {@link Layout#OPAQUE}. */
    static float cutoff(int body, float[] frame, float[] looks) {
        int maps = (int) looks[Layout.LOOK_STRIDE * body + Layout.LOOK_MAPS];
        float cutoff = Layout.OPAQUE;
        if (maps > 0) {
            cutoff = looks[SurfaceMaps.row(maps, frame) + Layout.MAPS_CUTOFF];
        }
        return cutoff;
    }

    /** Lets a part of the light pass a blended surface straight on, with its own color. */
    static void blend(float[] path, int body, float[] frame, float[] bodies, float[] looks, float[] meshes) {
        if (cutoff(body, frame, looks) == Layout.BLENDED) {
            int instance = Instance.at((int) path[Layout.INSTANCE], (int) frame[Layout.INSTANCES], bodies);
            int maps = (int) looks[Layout.LOOK_STRIDE * body + Layout.LOOK_MAPS];
            int triangle = Instance.triangles(bodies, instance) + Layout.TRIANGLE_STRIDE * (int) path[Layout.TRIANGLE];
            float b = path[Layout.CORNER_PARTS];
            float c = path[Layout.CORNER_PARTS + 1];
            float opacity = of(path, SurfaceMaps.row(maps, frame), instance, triangle, b, c, bodies, looks, meshes);
            path[Layout.TRANSMISSION] = 1f - opacity;
            path[Layout.REFLECTIVITY] = opacity * path[Layout.REFLECTIVITY];
            path[Layout.EMISSION] = opacity * path[Layout.EMISSION];
            path[Layout.EMISSION + 1] = opacity * path[Layout.EMISSION + 1];
            path[Layout.EMISSION + 2] = opacity * path[Layout.EMISSION + 2];
            path[Layout.IOR] = 1f;
            path[Layout.ROUGHNESS] = 0f;
            path[Layout.PASSING] = 1f;
            path[Layout.PASSING + 1] = 1f;
            path[Layout.PASSING + 2] = 1f;
        }
    }

    /** Where the ray meets a triangle. */
    private static float at(
            float[] path,
            int body,
            int instance,
            int number,
            float[] frame,
            float[] bodies,
            float[] looks,
            float[] meshes) {
        int triangle = Instance.triangles(bodies, instance) + Layout.TRIANGLE_STRIDE * number;
        float b = Triangle.part(path, triangle, 1, meshes);
        float c = Triangle.part(path, triangle, 2, meshes);
        int maps = (int) looks[Layout.LOOK_STRIDE * body + Layout.LOOK_MAPS];
        return of(path, SurfaceMaps.row(maps, frame), instance, triangle, b, c, bodies, looks, meshes);
    }

    /**
     * The opacity of a point of a triangle, in [0, 1].
     *
     * @param row place of the body's maps
     * @param triangle its place
     * @param b with c: weights of the second and the third corner
     */
    static float of(
            float[] path,
            int row,
            int instance,
            int triangle,
            float b,
            float c,
            float[] bodies,
            float[] looks,
            float[] meshes) {
        float opacity = looks[row + Layout.MAPS_ALPHA_FACTOR];
        if (looks[row + Layout.MAPS_VERTEX_COLORS] > 0f) {
            opacity = opacity * SurfaceMaps.vertexColor(instance, triangle, 3, b, c, bodies, meshes);
        }
        int map = row + Layout.MAPS_ALPHA;
        int width = (int) looks[map + Layout.MAP_WIDTH];
        int height = (int) looks[map + Layout.MAP_HEIGHT];
        if (width > 0) {
            int sampler = (int) looks[map + Layout.MAP_SAMPLER];
            int set = sampler / Layout.SAMPLER_COORDINATES;
            MeshSurface.writeTexturePlace(path, instance, triangle, set, b, c, bodies, meshes);
            int nearest = Texture.isNearest(sampler);
            int across = sampler % Layout.SAMPLER_DOWN;
            int down = sampler / Layout.SAMPLER_DOWN % Layout.SAMPLER_DOWN;
            float column = Texture.place(path[Layout.TEXTURE_PLACE], width, across, nearest);
            float line = Texture.place(path[Layout.TEXTURE_PLACE + 1], height, down, nearest);
            int start = Layout.ALIGNMENT * (int) looks[map + Layout.MAP_START];
            opacity = opacity * Texture.number(start, width, height, column, line, meshes);
        }
        return Math.min(Math.max(opacity, 0f), 1f);
    }
}
