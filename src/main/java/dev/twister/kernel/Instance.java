package dev.twister.kernel;

/** Places and directions of the world in the coordinates of an instance's mesh, and back. */
public final class Instance {
    private Instance() {}

    /**
     * A coordinate of a point.
     *
     * @param row where in the hierarchy the coordinate's row is
     */
    public static float point(float[] hierarchy, int row, float x, float y, float z) {
        return vector(hierarchy, row, x, y, z) + hierarchy[row + 3];
    }

    /** A coordinate of a vector. */
    public static float vector(float[] hierarchy, int row, float x, float y, float z) {
        return hierarchy[row] * x + hierarchy[row + 1] * y + hierarchy[row + 2] * z;
    }

    /** A coordinate of a normal of the mesh in the world, not a unit vector's. */
    public static float normal(float[] hierarchy, int instance, int axis, float x, float y, float z) {
        int column = instance + Layout.INSTANCE_TO_MESH + axis;
        return hierarchy[column] * x + hierarchy[column + 4] * y + hierarchy[column + 8] * z;
    }

    /** Where in the hierarchy an instance is. */
    public static int at(float[] hierarchy, int firstMesh, int number) {
        int section = Layout.instances(firstMesh);
        return section + 1 + Layout.NODE_STRIDE * (int) hierarchy[section] + Layout.INSTANCE_STRIDE * number;
    }

    /** Where in {@code meshes} its nodes begin. */
    public static int nodes(float[] hierarchy, int instance) {
        return Layout.MESH_ALIGNMENT * (int) hierarchy[instance + Layout.INSTANCE_MESH];
    }

    /** Where its triangles begin. */
    public static int triangles(float[] hierarchy, int instance) {
        return nodes(hierarchy, instance) + Layout.NODE_STRIDE * (int) hierarchy[instance + Layout.INSTANCE_NODES];
    }

    /** Where its normals begin. */
    public static int normals(float[] hierarchy, int instance) {
        return triangles(hierarchy, instance)
                + Layout.TRIANGLE_STRIDE * (int) hierarchy[instance + Layout.INSTANCE_TRIANGLES];
    }

    /** Where its vertices' places in the texture begin. */
    public static int texturePlaces(float[] hierarchy, int instance) {
        return normals(hierarchy, instance) + 3 * (int) hierarchy[instance + Layout.INSTANCE_NORMALS];
    }
}
