package dev.twister.kernel;

/**
 * Surfaces in one place. Rounding cannot tell their distances apart, so that the closer one would change from ray to
 * ray. The lower body is seen instead, and within a body the lower triangle.
 */
public final class Coincidence {
    /** Distances along a ray that differ by less, relative to themselves, may be those of one plane. */
    public static final float TOLERANCE = 0x1p-17f;

    /** Least squared cosine between the normals of faces in one plane: they differ by at most 0.6 degrees. */
    private static final float LEAST_COSINE_SQUARED = 1f - 1e-4f;

    private Coincidence() {}

    /**
     * 1 if a triangle that the ray hits replaces the closest hit so far, else 0. Overwrites the path's normals, which
     * are those of the surface that the ray has left.
     *
     * @param path {@link Layout#PATH_LENGTH} floats, with instance and triangle of the closest hit if that is a mesh
     * @param closest body of the closest hit
     * @param distance of the closest hit
     * @param met distance of the triangle, at most {@code distance} or larger by {@link #TOLERANCE}
     * @param number the triangle's instance
     */
    public static int replaces(
            float[] path,
            int closest,
            float distance,
            float met,
            int number,
            int triangle,
            float[] frame,
            float[] bodies,
            float[] meshes) {
        int replaces = met < distance ? 1 : 0;
        int meshHit = closest >= (int) frame[Layout.FIRST_MESH] ? 1 : 0;
        int mayCoincide = (met >= distance * (1f - TOLERANCE) ? 1 : 0) & (meshHit | (closest == Layout.PLANE ? 1 : 0));
        if (mayCoincide != 0) {
            int hierarchy = (int) frame[Layout.INSTANCES];
            int instance = Instance.at(number, hierarchy, bodies);
            int body = (int) bodies[instance + Layout.INSTANCE_BODY];
            int lower = (body < closest ? 1 : 0)
                    | ((body == closest ? 1 : 0) & (triangle < (int) path[Layout.TRIANGLE] ? 1 : 0));
            writeFace(path, Layout.FACE, instance, triangle, bodies, meshes);
            path[Layout.NORMAL] = 0f;
            path[Layout.NORMAL + 1] = 1f;
            path[Layout.NORMAL + 2] = 0f;
            if (meshHit != 0) {
                int other = Instance.at((int) path[Layout.INSTANCE], hierarchy, bodies);
                writeFace(path, Layout.NORMAL, other, (int) path[Layout.TRIANGLE], bodies, meshes);
            }
            float cosine = path[Layout.FACE] * path[Layout.NORMAL]
                    + path[Layout.FACE + 1] * path[Layout.NORMAL + 1]
                    + path[Layout.FACE + 2] * path[Layout.NORMAL + 2];
            int onePlane = cosine * cosine >= LEAST_COSINE_SQUARED ? 1 : 0;
            replaces = (onePlane | (met == distance ? 1 : 0)) != 0 ? lower : replaces;
        }
        return replaces;
    }

    private static void writeFace(float[] path, int at, int instance, int triangle, float[] bodies, float[] meshes) {
        int place = Instance.triangles(bodies, instance) + Layout.TRIANGLE_STRIDE * triangle;
        MeshSurface.writeFace(path, at, instance, place, bodies, meshes);
    }
}
