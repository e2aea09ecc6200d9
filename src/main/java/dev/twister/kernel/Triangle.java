package dev.twister.kernel;

/**
 * Watertight intersection of a ray and a triangle, from either side: no ray passes between triangles that share an edge
 * (Woop, Benthin and Wald, "Watertight Ray/Triangle Intersection", 2013). The corners are translated to the ray's
 * origin and sheared so that the ray runs along an axis. Both triangles of an edge then compute the same two products,
 * so their signs always agree, and a point on the edge is inside both. The direction need not be normalized: distances
 * are in its lengths.
 */
public final class Triangle {
    private Triangle() {}

    /** The dominant axis of a direction: 0 for x, 1 for y, 2 for z. */
    public static int longestAxis(float x, float y, float z) {
        float alongX = Math.abs(x);
        float alongY = Math.abs(y);
        float alongZ = Math.abs(z);
        int crossAxis = alongX > alongY ? 0 : 1;
        float crossLength = alongX > alongY ? alongX : alongY;
        return alongZ > crossLength ? 2 : crossAxis;
    }

    /** The next axis in cyclic order. */
    public static int after(int axis) {
        return axis == 2 ? 0 : axis + 1;
    }

    /** A component by its axis. */
    public static float along(int axis, float x, float y, float z) {
        float xOrY = axis == 0 ? x : y;
        return axis == 2 ? z : xOrY;
    }

    /**
     * Distance to the triangle in lengths of the direction; {@link Intersection#MISS} if the ray misses it or it is not
     * in front.
     *
     * @param path with the ray of {@link MeshRay}
     * @param at place of the triangle in {@code meshes}
     */
    public static float distance(float[] path, int at, float[] meshes) {
        int axis = (int) path[Layout.MESH_AXIS];
        float first = path[Layout.MESH_SHEARED];
        float second = path[Layout.MESH_SHEARED + 1];
        float third = path[Layout.MESH_SHEARED + 2];
        float shearFirst = path[Layout.MESH_SHEAR];
        float shearSecond = path[Layout.MESH_SHEAR + 1];
        int axisFirst = after(axis);
        int axisSecond = after(axisFirst);
        float depthA = meshes[at + axis] - third;
        float depthB = meshes[at + 3 + axis] - third;
        float depthC = meshes[at + 6 + axis] - third;
        float firstA = meshes[at + axisFirst] - first - shearFirst * depthA;
        float firstB = meshes[at + 3 + axisFirst] - first - shearFirst * depthB;
        float firstC = meshes[at + 6 + axisFirst] - first - shearFirst * depthC;
        float secondA = meshes[at + axisSecond] - second - shearSecond * depthA;
        float secondB = meshes[at + 3 + axisSecond] - second - shearSecond * depthB;
        float secondC = meshes[at + 6 + axisSecond] - second - shearSecond * depthC;
        float a = firstC * secondB - secondC * firstB;
        float b = firstA * secondC - secondA * firstC;
        float c = firstB * secondA - secondB * firstA;
        int below = (a < 0f ? 1 : 0) | (b < 0f ? 1 : 0) | (c < 0f ? 1 : 0);
        int above = (a > 0f ? 1 : 0) | (b > 0f ? 1 : 0) | (c > 0f ? 1 : 0);
        float sum = a + b + c;
        float distance = Intersection.MISS;
        if (((1 - (below & above)) & (sum != 0f ? 1 : 0)) != 0) {
            float along = (a * depthA + b * depthB + c * depthC) / sum * path[Layout.MESH_SHEAR + 2];
            distance = along > 0f ? along : Intersection.MISS;
        }
        return distance;
    }

    /**
     * The barycentric weight of a corner at the hit point, in [0, 1].
     *
     * @param corner 0, 1 or 2
     */
    static float part(float[] path, int at, int corner, float[] meshes) {
        int axis = (int) path[Layout.MESH_AXIS];
        float first = path[Layout.MESH_SHEARED];
        float second = path[Layout.MESH_SHEARED + 1];
        float third = path[Layout.MESH_SHEARED + 2];
        float shearFirst = path[Layout.MESH_SHEAR];
        float shearSecond = path[Layout.MESH_SHEAR + 1];
        int axisFirst = after(axis);
        int axisSecond = after(axisFirst);
        float depthA = meshes[at + axis] - third;
        float depthB = meshes[at + 3 + axis] - third;
        float depthC = meshes[at + 6 + axis] - third;
        float firstA = meshes[at + axisFirst] - first - shearFirst * depthA;
        float firstB = meshes[at + 3 + axisFirst] - first - shearFirst * depthB;
        float firstC = meshes[at + 6 + axisFirst] - first - shearFirst * depthC;
        float secondA = meshes[at + axisSecond] - second - shearSecond * depthA;
        float secondB = meshes[at + 3 + axisSecond] - second - shearSecond * depthB;
        float secondC = meshes[at + 6 + axisSecond] - second - shearSecond * depthC;
        float a = firstC * secondB - secondC * firstB;
        float b = firstA * secondC - secondA * firstC;
        float c = firstB * secondA - secondB * firstA;
        float aOrB = corner == 0 ? a : b;
        return (corner == 2 ? c : aOrB) / (a + b + c);
    }
}
