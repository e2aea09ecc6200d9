package dev.twister.kernel;

/** Transformations between the world and the coordinates of an instance's mesh. */
public final class Instance {
    private Instance() {}

    /**
     * One coordinate of a transformed point.
     *
     * @param row place of the coordinate's row in the hierarchy
     */
    public static float point(float[] hierarchy, int row, float x, float y, float z) {
        return vector(hierarchy, row, x, y, z) + hierarchy[row + 3];
    }

    /** One component of a transformed vector. */
    public static float vector(float[] hierarchy, int row, float x, float y, float z) {
        return hierarchy[row] * x + hierarchy[row + 1] * y + hierarchy[row + 2] * z;
    }

    /** One component of a mesh's normal in world space; the vector is not normalized. */
    public static float normal(float[] hierarchy, int instance, int axis, float x, float y, float z) {
        int column = instance + Layout.INSTANCE_TO_MESH + axis;
        return hierarchy[column] * x + hierarchy[column + 4] * y + hierarchy[column + 8] * z;
    }

    /** Place of an instance in the hierarchy. */
    public static int at(float[] hierarchy, int firstMesh, int number) {
        int section = Layout.instances(firstMesh);
        return section + 1 + Layout.NODE_STRIDE * (int) hierarchy[section] + Layout.INSTANCE_STRIDE * number;
    }

    /** Start of the instance's nodes in {@code meshes}. */
    public static int nodes(float[] hierarchy, int instance) {
        return Layout.MESH_ALIGNMENT * (int) hierarchy[instance + Layout.INSTANCE_MESH];
    }

    /** Start of its triangles. */
    public static int triangles(float[] hierarchy, int instance) {
        return nodes(hierarchy, instance) + Layout.NODE_STRIDE * (int) hierarchy[instance + Layout.INSTANCE_NODES];
    }

    /** Start of its vertex normals. */
    public static int normals(float[] hierarchy, int instance) {
        return triangles(hierarchy, instance)
                + Layout.TRIANGLE_STRIDE * (int) hierarchy[instance + Layout.INSTANCE_TRIANGLES];
    }

    /** Start of its vertices' texture coordinates. */
    public static int texturePlaces(float[] hierarchy, int instance) {
        return normals(hierarchy, instance) + 3 * (int) hierarchy[instance + Layout.INSTANCE_NORMALS];
    }
}
