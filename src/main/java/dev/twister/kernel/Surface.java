package dev.twister.kernel;

/** Hit point and normal on a body. */
public final class Surface {
    private Surface() {}

    /**
     * Writes whether the ray comes from inside, which requires a transmitting body. In that case a sphere's normal is
     * turned toward the ray's origin; a mesh's already is.
     *
     * @param path {@link Layout#PATH_LENGTH} floats, after {@link #find} and {@link Material#find}
     * @param body any except the light
     * @param firstMesh the first mesh's body, or {@link Layout#NO_MESHES}
     */
    static void face(float[] path, int body, int firstMesh) {
        int mesh = isMesh(body, firstMesh);
        int outward = mesh != 0 ? Layout.FACE : Layout.NORMAL;
        int transmits = (body == Layout.PLANE ? 0 : 1) & (path[Layout.TRANSMISSION] > 0f ? 1 : 0);
        int inside = transmits & (Facet.directionDot(path, outward) > 0f ? 1 : 0);
        path[Layout.FROM_INSIDE] = inside;
        int turned = inside & (1 - mesh);
        for (int axis = 0; axis < 3; axis++) {
            path[Layout.NORMAL + axis] = turned != 0 ? -path[Layout.NORMAL + axis] : path[Layout.NORMAL + axis];
        }
    }

    /**
     * Writes the point and the unit normal where the path's ray hits the body at {@link Layout#DISTANCE}. A sphere's
     * point is projected onto it for precision; the plane's normal is (0, 1, 0), seen from either side; for a mesh, see
     * {@link MeshSurface#find}.
     *
     * @param path {@link Layout#PATH_LENGTH} floats
     * @param body the result of {@link Hit#find}
     * @param places {@link Layout#PLACE_STRIDE} floats per body
     * @param firstMesh the first mesh's body, or {@link Layout#NO_MESHES}
     */
    public static void find(float[] path, int body, float[] places, float[] hierarchy, float[] meshes, int firstMesh) {
        if (isMesh(body, firstMesh) != 0) {
            MeshSurface.find(path, hierarchy, meshes, firstMesh);
        } else {
            findOnPlaneOrSphere(path, body, places);
        }
    }

    /** 1 if the body is a mesh, else 0. */
    static int isMesh(int body, int firstMesh) {
        return (firstMesh > Layout.NO_MESHES ? 1 : 0) & (body >= firstMesh ? 1 : 0);
    }

    private static void findOnPlaneOrSphere(float[] path, int body, float[] places) {
        float distance = path[Layout.DISTANCE];
        float pointX = path[Layout.ORIGIN] + distance * path[Layout.DIRECTION];
        float pointY = path[Layout.ORIGIN + 1] + distance * path[Layout.DIRECTION + 1];
        float pointZ = path[Layout.ORIGIN + 2] + distance * path[Layout.DIRECTION + 2];
        float centerX = places[Layout.PLACE_STRIDE * body];
        float centerY = places[Layout.PLACE_STRIDE * body + 1];
        float centerZ = places[Layout.PLACE_STRIDE * body + 2];
        float size = places[Layout.PLACE_STRIDE * body + Layout.PLACE_SIZE];
        float normalX = 0f;
        float normalY = 1f;
        float normalZ = 0f;
        if (body == Layout.PLANE) {
            pointY = centerY;
        } else {
            normalX = pointX - centerX;
            normalY = pointY - centerY;
            normalZ = pointZ - centerZ;
            float inverse = KernelMath.inverseRoot(normalX * normalX + normalY * normalY + normalZ * normalZ);
            normalX = normalX * inverse;
            normalY = normalY * inverse;
            normalZ = normalZ * inverse;
            pointX = centerX + normalX * size;
            pointY = centerY + normalY * size;
            pointZ = centerZ + normalZ * size;
        }
        path[Layout.POINT] = pointX;
        path[Layout.POINT + 1] = pointY;
        path[Layout.POINT + 2] = pointZ;
        path[Layout.NORMAL] = normalX;
        path[Layout.NORMAL + 1] = normalY;
        path[Layout.NORMAL + 2] = normalZ;
    }
}
