package dev.twister.kernel;

/** A triangle of a mesh that emits. */
final class TriangleEmitter {
    private TriangleEmitter() {}

    /**
     * Writes the direction to a point of a triangle, uniform in its area, and what {@link Emitter#choose} writes.
     *
     * @param emitter its place in {@code looks}
     */
    static void choose(
            float[] path,
            int emitter,
            float first,
            float second,
            float[] frame,
            float[] bodies,
            float[] looks,
            float[] meshes) {
        int instance =
                Instance.at((int) looks[emitter + Layout.EMITTER_INSTANCE], (int) frame[Layout.INSTANCES], bodies);
        int triangle = Instance.triangles(bodies, instance)
                + Layout.TRIANGLE_STRIDE * (int) looks[emitter + Layout.EMITTER_TRIANGLE];
        float b = secondCorner(first, second);
        float c = thirdCorner(first, second);
        float meshX = meshes[triangle]
                + b * (meshes[triangle + 3] - meshes[triangle])
                + c * (meshes[triangle + 6] - meshes[triangle]);
        float meshY = meshes[triangle + 1]
                + b * (meshes[triangle + 4] - meshes[triangle + 1])
                + c * (meshes[triangle + 7] - meshes[triangle + 1]);
        float meshZ = meshes[triangle + 2]
                + b * (meshes[triangle + 5] - meshes[triangle + 2])
                + c * (meshes[triangle + 8] - meshes[triangle + 2]);
        int row = instance + Layout.INSTANCE_TO_WORLD;
        float x = Instance.point(bodies, row, meshX, meshY, meshZ) - path[Layout.POINT];
        float y = Instance.point(bodies, row + 4, meshX, meshY, meshZ) - path[Layout.POINT + 1];
        float z = Instance.point(bodies, row + 8, meshX, meshY, meshZ) - path[Layout.POINT + 2];
        float squared = x * x + y * y + z * z;
        float inverse = KernelMath.inverseRoot(squared);
        path[Layout.TO_LIGHT] = x * inverse;
        path[Layout.TO_LIGHT + 1] = y * inverse;
        path[Layout.TO_LIGHT + 2] = z * inverse;
        MeshSurface.writeFace(path, Layout.EMITTER_FACE, instance, triangle, bodies, meshes);
        float along = path[Layout.TO_LIGHT] * path[Layout.EMITTER_FACE]
                + path[Layout.TO_LIGHT + 1] * path[Layout.EMITTER_FACE + 1]
                + path[Layout.TO_LIGHT + 2] * path[Layout.EMITTER_FACE + 2];
        int body = (int) looks[emitter + Layout.EMITTER_BODY];
        int shines = (along < 0f ? 1 : 0) | Emitter.isTwoSided(body, looks);
        float spread = Math.abs(along) * looks[emitter + Layout.EMITTER_AREA];
        // Slightly before the triangle, so that it does not block itself.
        path[Layout.LIGHT_DISTANCE] = squared * inverse * (1f - 0x1p-13f);
        path[Layout.LIGHT_DENSITY] = (shines & (spread > 0f ? 1 : 0)) != 0 ? squared / spread : 0f;
    }

    /** The weight of a triangle's second corner at the point that two numbers in [0, 1) choose. */
    static float secondCorner(float first, float second) {
        return (float) Math.sqrt(first) * (1f - second);
    }

    /** That of the third corner. */
    static float thirdCorner(float first, float second) {
        return (float) Math.sqrt(first) * second;
    }

    /**
     * Density per steradian of the direction of the path's ray, which has hit the triangle.
     *
     * @param emitter its place in {@code looks}
     */
    static float density(float[] path, int emitter, float[] looks) {
        float spread = Math.abs(Facet.directionDot(path, Layout.FACE)) * looks[emitter + Layout.EMITTER_AREA];
        return spread > 0f ? path[Layout.DISTANCE] * path[Layout.DISTANCE] / spread : 0f;
    }
}
