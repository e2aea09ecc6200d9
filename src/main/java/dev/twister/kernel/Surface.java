package dev.twister.kernel;

/** Hit point and normal on a body. */
public final class Surface {
    private Surface() {}

    /**
     * Writes whether the ray comes from inside, which requires a body that light passes. In that case a sphere's normal
     * is turned toward the ray's origin; a mesh's already is.
     *
     * @param path {@link Layout#PATH_LENGTH} floats, after {@link #find} and {@link SurfaceLook#find}
     * @param body any except the light
     */
    static void face(float[] path, int body, float[] frame, int variant) {
        int mesh = isMesh(body, frame, variant);
        // A place that is known only at run time would keep the whole path in memory on some devices.
        float along = mesh != 0 ? Facet.directionDot(path, Layout.FACE) : Facet.directionDot(path, Layout.NORMAL);
        int transmits = (body == Layout.PLANE ? 0 : 1) & isPassedHere(path, variant);
        int inside = transmits & (along > 0f ? 1 : 0);
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
     */
    public static void find(float[] path, int body, float[] frame, float[] bodies, float[] meshes, int variant) {
        if (isMesh(body, frame, variant) != 0) {
            MeshSurface.find(path, frame, bodies, meshes, variant);
        } else {
            findOnPlaneOrSphere(path, body, bodies);
        }
    }

    private static int isPassedHere(float[] path, int variant) {
        int passed = path[Layout.TRANSMISSION] > 0f ? 1 : 0;
        if ((variant & Variant.FINISH) != 0) {
            passed = path[Layout.TRANSMISSION] + path[Layout.IS_SHEET] > 0f ? 1 : 0;
        }
        return passed;
    }

    /**
     * 1 if light may pass the body's surface, so that its inner side is seen, else 0. A diffuse sheet, which transmits
     * nothing else, passes light in path tracing alone.
     */
    static int isPassed(int body, float[] looks, int variant) {
        int look = Layout.LOOK_STRIDE * body;
        int passed = looks[look + Layout.LOOK_TRANSMISSION] > 0f ? 1 : 0;
        if ((variant & Variant.FINISH) != 0) {
            passed = looks[look + Layout.LOOK_TRANSMISSION] + looks[look + Layout.LOOK_SHEET] > 0f ? 1 : 0;
        }
        return passed;
    }

    /** 1 if the body is a mesh, else 0. */
    static int isMesh(int body, float[] frame, int variant) {
        int mesh = 0;
        if ((variant & Variant.MESHES) != 0) {
            mesh = body >= frame[Layout.FIRST_MESH] ? 1 : 0;
        }
        return mesh;
    }

    /** 1 if the body is a light, which is drawn in its own color, else 0. */
    static int isLight(int body, float[] looks, int variant) {
        int isLight = body == Layout.LIGHT ? 1 : 0;
        if ((variant & Variant.LIGHTS) != 0) {
            int look = Layout.LOOK_STRIDE * (body > Layout.NOTHING ? body : Layout.PLANE);
            isLight = looks[look + Layout.LOOK_LIGHT] > 0f ? 1 : 0;
        }
        return isLight;
    }

    private static void findOnPlaneOrSphere(float[] path, int body, float[] bodies) {
        float distance = path[Layout.DISTANCE];
        float pointX = path[Layout.ORIGIN] + distance * path[Layout.DIRECTION];
        float pointY = path[Layout.ORIGIN + 1] + distance * path[Layout.DIRECTION + 1];
        float pointZ = path[Layout.ORIGIN + 2] + distance * path[Layout.DIRECTION + 2];
        float centerX = bodies[Layout.PLACE_STRIDE * body];
        float centerY = bodies[Layout.PLACE_STRIDE * body + 1];
        float centerZ = bodies[Layout.PLACE_STRIDE * body + 2];
        float size = bodies[Layout.PLACE_STRIDE * body + Layout.PLACE_SIZE];
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
