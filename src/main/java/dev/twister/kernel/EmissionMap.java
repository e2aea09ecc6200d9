package dev.twister.kernel;

/** Emission maps of emitters that a path chooses. Only with {@link Variant#MAPS}. */
final class EmissionMap {
    private EmissionMap() {}

    /** Multiplies {@link Layout#EMITTED} by the sphere's map where the direction to it meets the sphere. */
    static void ofSphere(float[] path, int body, float[] frame, float[] bodies, float[] looks, float[] images) {
        int maps = (int) looks[Layout.LOOK_STRIDE * body + Layout.LOOK_MAPS];
        int map = SurfaceMaps.row(maps, frame) + Layout.MAPS_EMISSION;
        if (maps > 0) {
            if (looks[map + Layout.MAP_WIDTH] > 0f) {
                int place = Layout.PLACE_STRIDE * body;
                float distance = path[Layout.LIGHT_DISTANCE];
                float x = path[Layout.POINT] + distance * path[Layout.TO_LIGHT] - bodies[place];
                float y = path[Layout.POINT + 1] + distance * path[Layout.TO_LIGHT + 1] - bodies[place + 1];
                float z = path[Layout.POINT + 2] + distance * path[Layout.TO_LIGHT + 2] - bodies[place + 2];
                float inverse = KernelMath.inverseRoot(x * x + y * y + z * z);
                Texture.aimAround(path, map, x * inverse, y * inverse, z * inverse, looks);
                multiply(path, map, looks, images);
            }
        }
    }

    /**
     * Multiplies {@link Layout#EMITTED} by the map and the opacity of a triangle at the chosen point.
     *
     * @param emitter its place in {@code looks}
     * @param first with second: the numbers that chose the point
     */
    static void ofTriangle(
            float[] path,
            int emitter,
            float first,
            float second,
            float[] frame,
            float[] bodies,
            float[] looks,
            float[] meshes,
            float[] images,
            int variant) {
        int body = (int) looks[emitter + Layout.EMITTER_BODY];
        int maps = (int) looks[Layout.LOOK_STRIDE * body + Layout.LOOK_MAPS];
        int row = SurfaceMaps.row(maps, frame);
        if (maps > 0) {
            int instance =
                    Instance.at((int) looks[emitter + Layout.EMITTER_INSTANCE], (int) frame[Layout.INSTANCES], bodies);
            int triangle = Instance.triangles(bodies, instance)
                    + Layout.TRIANGLE_STRIDE * (int) looks[emitter + Layout.EMITTER_TRIANGLE];
            float b = TriangleEmitter.secondCorner(first, second);
            float c = TriangleEmitter.thirdCorner(first, second);
            int map = row + Layout.MAPS_EMISSION;
            if ((variant & Variant.MASKS) != 0) {
                float least = looks[row + Layout.MAPS_CUTOFF];
                float opacity = Opacity.of(path, row, instance, triangle, b, c, bodies, looks, meshes);
                float kept = opacity < least ? 0f : 1f;
                float part = least == Layout.BLENDED ? opacity : kept;
                scale(path, least == Layout.OPAQUE ? 1f : part);
            }
            if (looks[map + Layout.MAP_WIDTH] > 0f) {
                int set = (int) looks[map + Layout.MAP_SAMPLER] / Layout.SAMPLER_COORDINATES;
                MeshSurface.writeTexturePlace(path, instance, triangle, set, b, c, bodies, meshes);
                Texture.aim(path, map, body, frame, looks, variant);
                multiply(path, map, looks, images);
            }
        }
    }

    private static void scale(float[] path, float factor) {
        path[Layout.EMITTED] = factor * path[Layout.EMITTED];
        path[Layout.EMITTED + 1] = factor * path[Layout.EMITTED + 1];
        path[Layout.EMITTED + 2] = factor * path[Layout.EMITTED + 2];
    }

    private static void multiply(float[] path, int map, float[] looks, float[] images) {
        for (int channel = 0; channel < 3; channel++) {
            path[Layout.EMITTED + channel] =
                    path[Layout.EMITTED + channel] * Texture.channel(path, map, channel, looks, images);
        }
    }
}
