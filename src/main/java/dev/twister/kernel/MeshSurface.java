package dev.twister.kernel;

/** Hit point, normals and texture coordinates on a mesh. */
public final class MeshSurface {
    /**
     * Smallest squared length of an interpolated normal; below it, vertex normals cancel out and the face normal is
     * used.
     */
    public static final float LEAST_SQUARE = 1e-6f;

    private MeshSurface() {}

    /**
     * Writes the point, interpolated between the corners; the unit face normal; the shading normal, on the side that
     * the ray comes from; and the texture coordinates. It uses the instance and triangle written by {@link MeshHit}.
     * The path now leaves that triangle.
     *
     * @param path {@link Layout#PATH_LENGTH} floats
     */
    static void find(float[] path, float[] frame, float[] bodies, float[] meshes, int variant) {
        int instance = Instance.at((int) path[Layout.INSTANCE], (int) frame[Layout.INSTANCES], bodies);
        int triangle = Instance.triangles(bodies, instance) + Layout.TRIANGLE_STRIDE * (int) path[Layout.TRIANGLE];
        MeshRay.enter(
                path,
                instance,
                path[Layout.ORIGIN],
                path[Layout.ORIGIN + 1],
                path[Layout.ORIGIN + 2],
                path[Layout.DIRECTION],
                path[Layout.DIRECTION + 1],
                path[Layout.DIRECTION + 2],
                bodies);
        float b = Triangle.part(path, triangle, 1, meshes);
        float c = Triangle.part(path, triangle, 2, meshes);
        float x = between(triangle, 3, b, c, meshes);
        float y = between(triangle + 1, 3, b, c, meshes);
        float z = between(triangle + 2, 3, b, c, meshes);
        int back = instance + Layout.INSTANCE_TO_WORLD;
        path[Layout.POINT] = Instance.point(bodies, back, x, y, z);
        path[Layout.POINT + 1] = onPlane(
                Instance.point(bodies, back + 4, x, y, z),
                Instance.reach(bodies, back + 4, x, y, z),
                bodies[Layout.PLACE_STRIDE * Layout.PLANE + 1]);
        path[Layout.POINT + 2] = Instance.point(bodies, back + 8, x, y, z);
        writeFace(path, Layout.FACE, instance, triangle, bodies, meshes);
        writeNormal(path, instance, triangle, b, c, bodies, meshes);
        writeTexturePlace(path, instance, triangle, 0, b, c, bodies, meshes);
        if ((variant & Variant.MAPS) != 0) {
            path[Layout.CORNER_PARTS] = b;
            path[Layout.CORNER_PARTS + 1] = c;
        }
        path[Layout.LEAVING_TRIANGLE] = path[Layout.TRIANGLE];
    }

    /**
     * The height of a point: the plane's where rounding cannot tell them apart. A ray that leaves the point does not
     * meet the plane then, nor does a shadow ray.
     */
    private static float onPlane(float y, float reach, float height) {
        return Math.abs(y - height) <= Triangle.ROUNDING * (reach + Math.abs(height)) ? height : y;
    }

    /** Interpolates one coordinate of the corners, which are {@code stride} apart. */
    private static float between(int at, int stride, float b, float c, float[] meshes) {
        float a = meshes[at];
        return a + b * (meshes[at + stride] - a) + c * (meshes[at + 2 * stride] - a);
    }

    /** Writes a triangle's unit face normal in world space, on the side from which its corners are counterclockwise. */
    static void writeFace(float[] path, int at, int instance, int triangle, float[] bodies, float[] meshes) {
        float firstX = meshes[triangle + 3] - meshes[triangle];
        float firstY = meshes[triangle + 4] - meshes[triangle + 1];
        float firstZ = meshes[triangle + 5] - meshes[triangle + 2];
        float secondX = meshes[triangle + 6] - meshes[triangle];
        float secondY = meshes[triangle + 7] - meshes[triangle + 1];
        float secondZ = meshes[triangle + 8] - meshes[triangle + 2];
        float x = firstY * secondZ - firstZ * secondY;
        float y = firstZ * secondX - firstX * secondZ;
        float z = firstX * secondY - firstY * secondX;
        // Scaled first, because the squares of small triangles underflow.
        float largest = Math.max(Math.max(Math.abs(x), Math.abs(y)), Math.abs(z));
        float scale = largest > 0f ? 1f / largest : 0f;
        write(path, at, instance, x * scale, y * scale, z * scale, bodies);
    }

    /** Writes a mesh's normal as a unit vector in world space. */
    private static void write(
            float[] path, int at, int instance, float meshX, float meshY, float meshZ, float[] bodies) {
        float x = Instance.normal(bodies, instance, 0, meshX, meshY, meshZ);
        float y = Instance.normal(bodies, instance, 1, meshX, meshY, meshZ);
        float z = Instance.normal(bodies, instance, 2, meshX, meshY, meshZ);
        float inverse = KernelMath.inverseRoot(x * x + y * y + z * z);
        path[at] = x * inverse;
        path[at + 1] = y * inverse;
        path[at + 2] = z * inverse;
    }

    private static void writeNormal(
            float[] path, int instance, int triangle, float b, float c, float[] bodies, float[] meshes) {
        path[Layout.NORMAL] = path[Layout.FACE];
        path[Layout.NORMAL + 1] = path[Layout.FACE + 1];
        path[Layout.NORMAL + 2] = path[Layout.FACE + 2];
        if (bodies[instance + Layout.INSTANCE_NORMALS] > 0f) {
            int normals = Instance.normals(bodies, instance);
            int atA = normals + 3 * (int) meshes[triangle + Layout.TRIANGLE_VERTICES];
            int atB = normals + 3 * (int) meshes[triangle + Layout.TRIANGLE_VERTICES + 1];
            int atC = normals + 3 * (int) meshes[triangle + Layout.TRIANGLE_VERTICES + 2];
            float a = 1f - b - c;
            float x = a * meshes[atA] + b * meshes[atB] + c * meshes[atC];
            float y = a * meshes[atA + 1] + b * meshes[atB + 1] + c * meshes[atC + 1];
            float z = a * meshes[atA + 2] + b * meshes[atB + 2] + c * meshes[atC + 2];
            if (x * x + y * y + z * z > LEAST_SQUARE) {
                write(path, Layout.NORMAL, instance, x, y, z, bodies);
            }
        }
        float faceAway = Facet.directionDot(path, Layout.FACE) > 0f ? -1f : 1f;
        float together = path[Layout.NORMAL] * path[Layout.FACE]
                + path[Layout.NORMAL + 1] * path[Layout.FACE + 1]
                + path[Layout.NORMAL + 2] * path[Layout.FACE + 2];
        float side = together < 0f ? -faceAway : faceAway;
        path[Layout.NORMAL] = side * path[Layout.NORMAL];
        path[Layout.NORMAL + 1] = side * path[Layout.NORMAL + 1];
        path[Layout.NORMAL + 2] = side * path[Layout.NORMAL + 2];
    }

    /**
     * Writes texture coordinates of a point of a triangle.
     *
     * @param set which of the mesh's coordinates, from 0 on
     * @param b with c: weights of the second and the third corner
     */
    static void writeTexturePlace(
            float[] path, int instance, int triangle, int set, float b, float c, float[] bodies, float[] meshes) {
        if (bodies[instance + Layout.INSTANCE_TEXTURE_PLACES] > 0f) {
            int places = Instance.texturePlaces(bodies, instance)
                    + 2 * set * (int) bodies[instance + Layout.INSTANCE_VERTICES];
            int atA = places + 2 * (int) meshes[triangle + Layout.TRIANGLE_VERTICES];
            int atB = places + 2 * (int) meshes[triangle + Layout.TRIANGLE_VERTICES + 1];
            int atC = places + 2 * (int) meshes[triangle + Layout.TRIANGLE_VERTICES + 2];
            float u = meshes[atA];
            float v = meshes[atA + 1];
            path[Layout.TEXTURE_PLACE] = u + b * (meshes[atB] - u) + c * (meshes[atC] - u);
            path[Layout.TEXTURE_PLACE + 1] = v + b * (meshes[atB + 1] - v) + c * (meshes[atC + 1] - v);
        }
    }

    /** 1 if the side of the face that the ray sees looks away from the light. */
    static int looksAway(float[] path) {
        float toLight = path[Layout.FACE] * path[Layout.TO_LIGHT]
                + path[Layout.FACE + 1] * path[Layout.TO_LIGHT + 1]
                + path[Layout.FACE + 2] * path[Layout.TO_LIGHT + 2];
        float away = Facet.directionDot(path, Layout.FACE) > 0f ? toLight : -toLight;
        return away >= 0f ? 1 : 0;
    }
}
