package dev.twister.kernel;

/** A ray in the coordinates of an instance's mesh. Distances remain those of the world. */
public final class MeshRay {
    private MeshRay() {}

    /**
     * Writes the ray's origin and direction, its dominant axis, and what {@link Triangle} needs of them.
     *
     * @param path {@link Layout#PATH_LENGTH} floats
     * @param instance place of the instance in {@code bodies}
     * @param x with y and z: the origin in the world
     * @param alongX with alongY and alongZ: the direction in the world
     */
    public static void enter(
            float[] path,
            int instance,
            float x,
            float y,
            float z,
            float alongX,
            float alongY,
            float alongZ,
            float[] bodies) {
        int row = instance + Layout.INSTANCE_TO_MESH;
        float originX = Instance.point(bodies, row, x, y, z);
        float originY = Instance.point(bodies, row + 4, x, y, z);
        float originZ = Instance.point(bodies, row + 8, x, y, z);
        float directionX = Instance.vector(bodies, row, alongX, alongY, alongZ);
        float directionY = Instance.vector(bodies, row + 4, alongX, alongY, alongZ);
        float directionZ = Instance.vector(bodies, row + 8, alongX, alongY, alongZ);
        float reach = Math.max(
                Math.max(Instance.reach(bodies, row, x, y, z), Instance.reach(bodies, row + 4, x, y, z)),
                Instance.reach(bodies, row + 8, x, y, z));
        write(path, originX, originY, originZ, directionX, directionY, directionZ, reach);
    }

    /**
     * As {@link #enter} for a small mesh, whose triangles are in the world's coordinates.
     *
     * @param small its place in {@code bodies}
     */
    public static void stay(
            float[] path,
            int small,
            float x,
            float y,
            float z,
            float alongX,
            float alongY,
            float alongZ,
            float[] bodies) {
        float reach = Math.max(Math.max(Math.abs(x), Math.abs(y)), Math.abs(z)) + bodies[small + Layout.SMALL_REACH];
        write(path, x, y, z, alongX, alongY, alongZ, reach);
    }

    private static void write(
            float[] path,
            float originX,
            float originY,
            float originZ,
            float directionX,
            float directionY,
            float directionZ,
            float reach) {
        int axis = Triangle.longestAxis(directionX, directionY, directionZ);
        int firstAxis = Triangle.after(axis);
        int secondAxis = Triangle.after(firstAxis);
        float inverse = 1f / Triangle.along(axis, directionX, directionY, directionZ);
        path[Layout.MESH_ORIGIN] = originX;
        path[Layout.MESH_ORIGIN + 1] = originY;
        path[Layout.MESH_ORIGIN + 2] = originZ;
        path[Layout.MESH_DIRECTION] = directionX;
        path[Layout.MESH_DIRECTION + 1] = directionY;
        path[Layout.MESH_DIRECTION + 2] = directionZ;
        path[Layout.MESH_AXIS] = axis;
        path[Layout.MESH_SHEARED] = Triangle.along(firstAxis, originX, originY, originZ);
        path[Layout.MESH_SHEARED + 1] = Triangle.along(secondAxis, originX, originY, originZ);
        path[Layout.MESH_SHEARED + 2] = Triangle.along(axis, originX, originY, originZ);
        path[Layout.MESH_SHEAR] = Triangle.along(firstAxis, directionX, directionY, directionZ) * inverse;
        path[Layout.MESH_SHEAR + 1] = Triangle.along(secondAxis, directionX, directionY, directionZ) * inverse;
        path[Layout.MESH_SHEAR + 2] = inverse;
        path[Layout.MESH_REACH] = reach;
    }
}
