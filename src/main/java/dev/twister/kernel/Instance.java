package dev.twister.kernel;

/** Transformations between the world and the coordinates of an instance's mesh. */
public final class Instance {
    private Instance() {}

    /**
     * One coordinate of a transformed point.
     *
     * @param row place of the coordinate's row
     */
    public static float point(float[] bodies, int row, float x, float y, float z) {
        return vector(bodies, row, x, y, z) + bodies[row + 3];
    }

    /** The sum of the magnitudes that {@link #point} adds, in whose units in the last place it is rounded. */
    public static float reach(float[] bodies, int row, float x, float y, float z) {
        return Math.abs(bodies[row] * x)
                + Math.abs(bodies[row + 1] * y)
                + Math.abs(bodies[row + 2] * z)
                + Math.abs(bodies[row + 3]);
    }

    /** One component of a transformed vector. */
    public static float vector(float[] bodies, int row, float x, float y, float z) {
        return bodies[row] * x + bodies[row + 1] * y + bodies[row + 2] * z;
    }

    /** One component of a mesh's normal in world space; the vector is not normalized. */
    public static float normal(float[] bodies, int instance, int axis, float x, float y, float z) {
        int column = instance + Layout.INSTANCE_TO_MESH + axis;
        return bodies[column] * x + bodies[column + 4] * y + bodies[column + 8] * z;
    }

    /**
     * Place of an instance.
     *
     * @param hierarchy place of the meshes' hierarchy
     */
    public static int at(int number, int hierarchy, float[] bodies) {
        return hierarchy + 1 + Layout.NODE_STRIDE * (int) bodies[hierarchy] + Layout.INSTANCE_STRIDE * number;
    }

    /** Start of the instance's nodes in {@code meshes}. */
    public static int nodes(float[] bodies, int instance) {
        return Layout.ALIGNMENT * (int) bodies[instance + Layout.INSTANCE_MESH];
    }

    /** Start of its triangles. */
    public static int triangles(float[] bodies, int instance) {
        return nodes(bodies, instance) + Layout.NODE_STRIDE * (int) bodies[instance + Layout.INSTANCE_NODES];
    }

    /** Start of its vertex normals. */
    public static int normals(float[] bodies, int instance) {
        return triangles(bodies, instance)
                + Layout.TRIANGLE_STRIDE * (int) bodies[instance + Layout.INSTANCE_TRIANGLES];
    }

    /** Start of its vertices' texture coordinates. */
    public static int texturePlaces(float[] bodies, int instance) {
        return normals(bodies, instance) + 3 * (int) bodies[instance + Layout.INSTANCE_NORMALS];
    }

    /** Start of its vertex colors. */
    public static int colors(float[] bodies, int instance) {
        return texturePlaces(bodies, instance) + 2 * (int) bodies[instance + Layout.INSTANCE_TEXTURE_PLACES];
    }

    /** Start of its tangents. */
    public static int tangents(float[] bodies, int instance) {
        return colors(bodies, instance) + 4 * (int) bodies[instance + Layout.INSTANCE_COLORS];
    }
}
