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
     * @param firstMesh the first mesh's body
     */
    static void find(float[] path, float[] hierarchy, float[] meshes, int firstMesh) {
        int instance = Instance.at(hierarchy, firstMesh, (int) path[Layout.INSTANCE]);
        int triangle = Instance.triangles(hierarchy, instance) + Layout.TRIANGLE_STRIDE * (int) path[Layout.TRIANGLE];
        int row = instance + Layout.INSTANCE_TO_MESH;
        float worldX = path[Layout.ORIGIN];
        float worldY = path[Layout.ORIGIN + 1];
        float worldZ = path[Layout.ORIGIN + 2];
        float originX = Instance.point(hierarchy, row, worldX, worldY, worldZ);
        float originY = Instance.point(hierarchy, row + 4, worldX, worldY, worldZ);
        float originZ = Instance.point(hierarchy, row + 8, worldX, worldY, worldZ);
        float alongX = path[Layout.DIRECTION];
        float alongY = path[Layout.DIRECTION + 1];
        float alongZ = path[Layout.DIRECTION + 2];
        float directionX = Instance.vector(hierarchy, row, alongX, alongY, alongZ);
        float directionY = Instance.vector(hierarchy, row + 4, alongX, alongY, alongZ);
        float directionZ = Instance.vector(hierarchy, row + 8, alongX, alongY, alongZ);
        int axis = Triangle.longestAxis(directionX, directionY, directionZ);
        int firstAxis = Triangle.after(axis);
        int secondAxis = Triangle.after(firstAxis);
        float first = Triangle.along(firstAxis, originX, originY, originZ);
        float second = Triangle.along(secondAxis, originX, originY, originZ);
        float third = Triangle.along(axis, originX, originY, originZ);
        float inverse = 1f / Triangle.along(axis, directionX, directionY, directionZ);
        float shearFirst = Triangle.along(firstAxis, directionX, directionY, directionZ) * inverse;
        float shearSecond = Triangle.along(secondAxis, directionX, directionY, directionZ) * inverse;
        float b = Triangle.part(meshes, triangle, 1, axis, first, second, third, shearFirst, shearSecond);
        float c = Triangle.part(meshes, triangle, 2, axis, first, second, third, shearFirst, shearSecond);
        float x = between(meshes, triangle, 3, b, c);
        float y = between(meshes, triangle + 1, 3, b, c);
        float z = between(meshes, triangle + 2, 3, b, c);
        int back = instance + Layout.INSTANCE_TO_WORLD;
        path[Layout.POINT] = Instance.point(hierarchy, back, x, y, z);
        path[Layout.POINT + 1] = Instance.point(hierarchy, back + 4, x, y, z);
        path[Layout.POINT + 2] = Instance.point(hierarchy, back + 8, x, y, z);
        writeFace(path, hierarchy, instance, meshes, triangle);
        writeNormal(path, hierarchy, instance, meshes, triangle, b, c);
        writeTexturePlace(path, hierarchy, instance, meshes, triangle, b, c);
        path[Layout.LEAVING_TRIANGLE] = path[Layout.TRIANGLE];
    }

    /** Interpolates one coordinate of the corners, which are {@code stride} apart. */
    private static float between(float[] meshes, int at, int stride, float b, float c) {
        float a = meshes[at];
        return a + b * (meshes[at + stride] - a) + c * (meshes[at + 2 * stride] - a);
    }

    private static void writeFace(float[] path, float[] hierarchy, int instance, float[] meshes, int triangle) {
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
        write(path, Layout.FACE, hierarchy, instance, x * scale, y * scale, z * scale);
    }

    /** Writes a mesh's normal as a unit vector in world space. */
    private static void write(
            float[] path, int at, float[] hierarchy, int instance, float meshX, float meshY, float meshZ) {
        float x = Instance.normal(hierarchy, instance, 0, meshX, meshY, meshZ);
        float y = Instance.normal(hierarchy, instance, 1, meshX, meshY, meshZ);
        float z = Instance.normal(hierarchy, instance, 2, meshX, meshY, meshZ);
        float inverse = KernelMath.inverseRoot(x * x + y * y + z * z);
        path[at] = x * inverse;
        path[at + 1] = y * inverse;
        path[at + 2] = z * inverse;
    }

    private static void writeNormal(
            float[] path, float[] hierarchy, int instance, float[] meshes, int triangle, float b, float c) {
        path[Layout.NORMAL] = path[Layout.FACE];
        path[Layout.NORMAL + 1] = path[Layout.FACE + 1];
        path[Layout.NORMAL + 2] = path[Layout.FACE + 2];
        if (hierarchy[instance + Layout.INSTANCE_NORMALS] > 0f) {
            int normals = Instance.normals(hierarchy, instance);
            int atA = normals + 3 * (int) meshes[triangle + Layout.TRIANGLE_VERTICES];
            int atB = normals + 3 * (int) meshes[triangle + Layout.TRIANGLE_VERTICES + 1];
            int atC = normals + 3 * (int) meshes[triangle + Layout.TRIANGLE_VERTICES + 2];
            float a = 1f - b - c;
            float x = a * meshes[atA] + b * meshes[atB] + c * meshes[atC];
            float y = a * meshes[atA + 1] + b * meshes[atB + 1] + c * meshes[atC + 1];
            float z = a * meshes[atA + 2] + b * meshes[atB + 2] + c * meshes[atC + 2];
            if (x * x + y * y + z * z > LEAST_SQUARE) {
                write(path, Layout.NORMAL, hierarchy, instance, x, y, z);
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

    private static void writeTexturePlace(
            float[] path, float[] hierarchy, int instance, float[] meshes, int triangle, float b, float c) {
        if (hierarchy[instance + Layout.INSTANCE_TEXTURE_PLACES] > 0f) {
            int places = Instance.texturePlaces(hierarchy, instance);
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
