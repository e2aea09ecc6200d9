package dev.twister.kernel;

/**
 * Watertight intersection of a ray and a triangle, from either side: no ray passes between triangles that share an edge
 * (Woop, Benthin and Wald, "Watertight Ray/Triangle Intersection", 2013). The corners are translated to the ray's
 * origin and sheared so that the ray runs along an axis. Both triangles of an edge then compute the same two products,
 * so their signs always agree, and a point on the edge is inside both. The direction need not be normalized: distances
 * are in its lengths.
 */
public final class Triangle {
    /**
     * A ray's origin that is no farther from a triangle's plane may lie in it, relative to the sum of the origin's
     * reach ({@link Layout#MESH_REACH}) and the triangle's largest coordinate. An origin on a surface has gone from
     * mesh to world and to mesh, with 4 roundings in each, and so has a coincident triangle's placement; the distance
     * itself has up to 16.
     */
    public static final float ROUNDING = 0x1p-20f;

    /** Distance of a surface in which a ray starts, if it meets it. */
    public static final float TOUCHING = 1e-30f;

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
     * Distance to the triangle in lengths of the direction; {@link Intersection#MISS} if the ray misses it, if it is
     * not in front, or if rounding cannot tell whether the ray starts in its plane. So a ray that leaves a surface
     * meets none in the same place, at whatever angle (unless {@link Layout#MESH_REACH} says so), and a triangle at a
     * millionth of the coordinates is still met.
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
            // The volume between the origin and the triangle: its area times its plane's distance.
            float volume = a * depthA + b * depthB + c * depthC;
            float along = volume / sum * path[Layout.MESH_SHEAR + 2];
            float reach = path[Layout.MESH_REACH];
            int apart = Math.abs(volume) > slack(at, meshes) * (Math.abs(reach) + largest(at, meshes)) ? 1 : 0;
            int touches = (reach < 0f ? 1 : 0) & (1 - apart);
            float touching = touches != 0 ? Math.max(along, TOUCHING) : Intersection.MISS;
            distance = (apart & (along > 0f ? 1 : 0)) != 0 ? along : touching;
        }
        return distance;
    }

    /** {@link #ROUNDING} times the triangle's area: a sum of the magnitudes of its normal's components. */
    public static float slack(int at, float[] meshes) {
        float firstX = meshes[at + 3] - meshes[at];
        float firstY = meshes[at + 4] - meshes[at + 1];
        float firstZ = meshes[at + 5] - meshes[at + 2];
        float secondX = meshes[at + 6] - meshes[at];
        float secondY = meshes[at + 7] - meshes[at + 1];
        float secondZ = meshes[at + 8] - meshes[at + 2];
        return ROUNDING
                * (Math.abs(firstY * secondZ - firstZ * secondY)
                        + Math.abs(firstZ * secondX - firstX * secondZ)
                        + Math.abs(firstX * secondY - firstY * secondX));
    }

    /** The largest magnitude of its first corner's coordinates. */
    public static float largest(int at, float[] meshes) {
        return Math.max(Math.max(Math.abs(meshes[at]), Math.abs(meshes[at + 1])), Math.abs(meshes[at + 2]));
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
