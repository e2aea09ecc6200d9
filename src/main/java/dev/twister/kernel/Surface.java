package dev.twister.kernel;

/** Where a ray meets a body, and which way its surface faces there. */
public final class Surface {
    private Surface() {}

    /**
     * Turns the normal of a sphere against a ray that comes from inside, as it can where the sphere transmits.
     *
     * @param path {@link Layout#PATH_LENGTH} floats, after {@link #find} and {@link Material#find}
     * @param body the plane or a sphere
     */
    static void face(float[] path, int body) {
        int transmits = (body == Layout.PLANE ? 0 : 1) & (path[Layout.TRANSMISSION] > 0f ? 1 : 0);
        int inside = transmits & (Facet.directionDot(path, Layout.NORMAL) > 0f ? 1 : 0);
        path[Layout.FROM_INSIDE] = inside;
        for (int axis = 0; axis < 3; axis++) {
            path[Layout.NORMAL + axis] = inside != 0 ? -path[Layout.NORMAL + axis] : path[Layout.NORMAL + axis];
        }
    }

    /**
     * Writes the point and the unit normal where the path's ray meets the body at {@link Layout#DISTANCE}. A sphere's
     * point lies on it to the last digits; the plane's normal is (0, 1, 0), seen from either side.
     *
     * @param path {@link Layout#PATH_LENGTH} floats
     * @param body the plane or a sphere
     * @param places {@link Layout#PLACE_STRIDE} floats a body
     */
    public static void find(float[] path, int body, float[] places) {
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
