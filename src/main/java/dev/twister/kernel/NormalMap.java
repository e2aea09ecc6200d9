package dev.twister.kernel;

/** Normal maps, which turn the shading normal. */
final class NormalMap {
    /** Least cosine between the turned normal and the direction to the ray's origin. */
    private static final float LEAST_COSINE = 0.01f;

    private static final float LEAST_SQUARE = 1e-30f;

    private NormalMap() {}

    /**
     * Turns the normal at {@link Layout#POINT} as the body's map says, if it has one.
     *
     * @param path {@link Layout#PATH_LENGTH} floats, after {@link Surface#face}
     */
    static void apply(
            float[] path,
            int body,
            float[] frame,
            float[] bodies,
            float[] looks,
            float[] meshes,
            float[] images,
            int variant) {
        int maps = (int) looks[Layout.LOOK_STRIDE * body + Layout.LOOK_MAPS];
        int map = SurfaceMaps.row(maps, frame) + Layout.MAPS_NORMAL;
        if (maps > 0) {
            if (looks[map + Layout.MAP_WIDTH] > 0f) {
                float scale = looks[map + Layout.MAPS_NORMAL_SCALE - Layout.MAPS_NORMAL];
                turn(path, body, map, scale, frame, bodies, looks, meshes, images, variant);
            }
        }
    }

    /** -1 if the normal is on the body's inner side, else 1. */
    static float outward(float[] path, int body, float[] frame, int variant) {
        float outward = 1f;
        if (Surface.isMesh(body, frame, variant) != 0) {
            outward = Facet.directionDot(path, Layout.FACE) > 0f ? -1f : 1f;
        } else {
            outward = path[Layout.FROM_INSIDE] > 0f ? -1f : 1f;
        }
        return outward;
    }

    /**
     * Turns the normal as a map says.
     *
     * @param map its place in {@code looks}
     * @param scale factor of the map's x and y
     */
    static void turn(
            float[] path,
            int body,
            int map,
            float scale,
            float[] frame,
            float[] bodies,
            float[] looks,
            float[] meshes,
            float[] images,
            int variant) {
        float outward = outward(path, body, frame, variant);
        path[Layout.NORMAL] = outward * path[Layout.NORMAL];
        path[Layout.NORMAL + 1] = outward * path[Layout.NORMAL + 1];
        path[Layout.NORMAL + 2] = outward * path[Layout.NORMAL + 2];
        writeTangent(path, body, map, frame, bodies, looks, meshes, variant);
        Texture.aim(path, map, body, frame, looks, variant);
        float x = scale * (2f * Texture.channel(path, map, 0, looks, images) - 1f);
        float y = scale * (2f * Texture.channel(path, map, 1, looks, images) - 1f);
        float z = 2f * Texture.channel(path, map, 2, looks, images) - 1f;
        float normalX = path[Layout.NORMAL];
        float normalY = path[Layout.NORMAL + 1];
        float normalZ = path[Layout.NORMAL + 2];
        float along = path[Layout.TANGENT] * normalX
                + path[Layout.TANGENT + 1] * normalY
                + path[Layout.TANGENT + 2] * normalZ;
        float tangentX = path[Layout.TANGENT] - along * normalX;
        float tangentY = path[Layout.TANGENT + 1] - along * normalY;
        float tangentZ = path[Layout.TANGENT + 2] - along * normalZ;
        float squared = tangentX * tangentX + tangentY * tangentY + tangentZ * tangentZ;
        // Without a direction on the image, only the part along the normal is known.
        float inverse = squared > LEAST_SQUARE ? KernelMath.inverseRoot(squared) : 0f;
        tangentX = tangentX * inverse;
        tangentY = tangentY * inverse;
        tangentZ = tangentZ * inverse;
        float upX = normalY * tangentZ - normalZ * tangentY;
        float upY = normalZ * tangentX - normalX * tangentZ;
        float upZ = normalX * tangentY - normalY * tangentX;
        float side = upX * path[Layout.UPWARD] + upY * path[Layout.UPWARD + 1] + upZ * path[Layout.UPWARD + 2];
        float up = side < 0f ? -y : y;
        float turnedX = x * tangentX + up * upX + z * normalX;
        float turnedY = x * tangentY + up * upY + z * normalY;
        float turnedZ = x * tangentZ + up * upZ + z * normalZ;
        float length = turnedX * turnedX + turnedY * turnedY + turnedZ * turnedZ;
        int usable = length > 0f ? 1 : 0;
        inverse = outward * KernelMath.inverseRoot(length);
        path[Layout.NORMAL] = usable != 0 ? turnedX * inverse : outward * normalX;
        path[Layout.NORMAL + 1] = usable != 0 ? turnedY * inverse : outward * normalY;
        path[Layout.NORMAL + 2] = usable != 0 ? turnedZ * inverse : outward * normalZ;
        face(path, body);
    }

    /**
     * Turns a normal that looks away from the ray's origin so that it just does not. The plane's may look either way.
     */
    private static void face(float[] path, int body) {
        float away = Facet.directionDot(path, Layout.NORMAL);
        float side = ((body == Layout.PLANE ? 1 : 0) & (path[Layout.DIRECTION + 1] > 0f ? 1 : 0)) != 0 ? -1f : 1f;
        float excess = side * away + LEAST_COSINE;
        if (excess > 0f) {
            float x = path[Layout.NORMAL] - side * excess * path[Layout.DIRECTION];
            float y = path[Layout.NORMAL + 1] - side * excess * path[Layout.DIRECTION + 1];
            float z = path[Layout.NORMAL + 2] - side * excess * path[Layout.DIRECTION + 2];
            float inverse = KernelMath.inverseRoot(x * x + y * y + z * z);
            path[Layout.NORMAL] = x * inverse;
            path[Layout.NORMAL + 1] = y * inverse;
            path[Layout.NORMAL + 2] = z * inverse;
        }
    }

    /**
     * Writes the directions of the map's right and upper border on the surface, of any length. On a mesh it also writes
     * the map's texture coordinates, if it has any.
     */
    static void writeTangent(
            float[] path,
            int body,
            int map,
            float[] frame,
            float[] bodies,
            float[] looks,
            float[] meshes,
            int variant) {
        if (Surface.isMesh(body, frame, variant) != 0) {
            int instance = Instance.at((int) path[Layout.INSTANCE], (int) frame[Layout.INSTANCES], bodies);
            int triangle = Instance.triangles(bodies, instance) + Layout.TRIANGLE_STRIDE * (int) path[Layout.TRIANGLE];
            int set = (int) looks[map + Layout.MAP_SAMPLER] / Layout.SAMPLER_COORDINATES;
            float b = path[Layout.CORNER_PARTS];
            float c = path[Layout.CORNER_PARTS + 1];
            clearTangent(path);
            if (bodies[instance + Layout.INSTANCE_TEXTURE_PLACES] > 0f) {
                MeshSurface.writeTexturePlace(path, instance, triangle, set, b, c, bodies, meshes);
                writeImageAxes(path, instance, triangle, set, bodies, meshes);
            }
            if (bodies[instance + Layout.INSTANCE_TANGENTS] > 0f) {
                writeFileTangent(path, instance, triangle, bodies, meshes);
            }
        } else {
            int plane = body == Layout.PLANE ? 1 : 0;
            float x = path[Layout.NORMAL];
            float y = path[Layout.NORMAL + 1];
            float z = path[Layout.NORMAL + 2];
            path[Layout.TANGENT] = plane != 0 ? 1f : -z;
            path[Layout.TANGENT + 1] = 0f;
            path[Layout.TANGENT + 2] = plane != 0 ? 0f : x;
            path[Layout.UPWARD] = plane != 0 ? 0f : -x * y;
            path[Layout.UPWARD + 1] = plane != 0 ? 0f : 1f - y * y;
            path[Layout.UPWARD + 2] = plane != 0 ? 1f : -z * y;
        }
    }

    private static void clearTangent(float[] path) {
        for (int axis = 0; axis < 3; axis++) {
            path[Layout.TANGENT + axis] = 0f;
            path[Layout.UPWARD + axis] = 0f;
        }
    }

    /** From the texture coordinates of a triangle's corners. */
    private static void writeImageAxes(
            float[] path, int instance, int triangle, int set, float[] bodies, float[] meshes) {
        int places =
                Instance.texturePlaces(bodies, instance) + 2 * set * (int) bodies[instance + Layout.INSTANCE_VERTICES];
        int atA = places + 2 * (int) meshes[triangle + Layout.TRIANGLE_VERTICES];
        int atB = places + 2 * (int) meshes[triangle + Layout.TRIANGLE_VERTICES + 1];
        int atC = places + 2 * (int) meshes[triangle + Layout.TRIANGLE_VERTICES + 2];
        float uB = meshes[atB] - meshes[atA];
        float vB = meshes[atB + 1] - meshes[atA + 1];
        float uC = meshes[atC] - meshes[atA];
        float vC = meshes[atC + 1] - meshes[atA + 1];
        float area = uB * vC - uC * vB;
        float sign = area < 0f ? -1f : 1f;
        float known = area != 0f ? 1f : 0f;
        float firstX = meshes[triangle + 3] - meshes[triangle];
        float firstY = meshes[triangle + 4] - meshes[triangle + 1];
        float firstZ = meshes[triangle + 5] - meshes[triangle + 2];
        float secondX = meshes[triangle + 6] - meshes[triangle];
        float secondY = meshes[triangle + 7] - meshes[triangle + 1];
        float secondZ = meshes[triangle + 8] - meshes[triangle + 2];
        write(
                path,
                Layout.TANGENT,
                instance,
                known * sign * (vC * firstX - vB * secondX),
                known * sign * (vC * firstY - vB * secondY),
                known * sign * (vC * firstZ - vB * secondZ),
                bodies);
        write(
                path,
                Layout.UPWARD,
                instance,
                known * sign * (uC * firstX - uB * secondX),
                known * sign * (uC * firstY - uB * secondY),
                known * sign * (uC * firstZ - uB * secondZ),
                bodies);
    }

    /** Interpolated between a triangle's corners, with the first corner's sign. */
    private static void writeFileTangent(float[] path, int instance, int triangle, float[] bodies, float[] meshes) {
        int tangents = Instance.tangents(bodies, instance);
        int atA = tangents + 4 * (int) meshes[triangle + Layout.TRIANGLE_VERTICES];
        int atB = tangents + 4 * (int) meshes[triangle + Layout.TRIANGLE_VERTICES + 1];
        int atC = tangents + 4 * (int) meshes[triangle + Layout.TRIANGLE_VERTICES + 2];
        float b = path[Layout.CORNER_PARTS];
        float c = path[Layout.CORNER_PARTS + 1];
        float a = 1f - b - c;
        float x = a * meshes[atA] + b * meshes[atB] + c * meshes[atC];
        float y = a * meshes[atA + 1] + b * meshes[atB + 1] + c * meshes[atC + 1];
        float z = a * meshes[atA + 2] + b * meshes[atB + 2] + c * meshes[atC + 2];
        if (x * x + y * y + z * z > MeshSurface.LEAST_SQUARE) {
            int row = instance + Layout.INSTANCE_TO_WORLD;
            float toMirror = mirrors(row, bodies) * meshes[atA + 3];
            write(path, Layout.TANGENT, instance, x, y, z, bodies);
            float tangentX = path[Layout.TANGENT];
            float tangentY = path[Layout.TANGENT + 1];
            float tangentZ = path[Layout.TANGENT + 2];
            path[Layout.UPWARD] = toMirror * (path[Layout.NORMAL + 1] * tangentZ - path[Layout.NORMAL + 2] * tangentY);
            path[Layout.UPWARD + 1] = toMirror * (path[Layout.NORMAL + 2] * tangentX - path[Layout.NORMAL] * tangentZ);
            path[Layout.UPWARD + 2] = toMirror * (path[Layout.NORMAL] * tangentY - path[Layout.NORMAL + 1] * tangentX);
        }
    }

    /** -1 if the transformation mirrors, else 1. */
    private static float mirrors(int row, float[] bodies) {
        float determinant = bodies[row] * (bodies[row + 5] * bodies[row + 10] - bodies[row + 6] * bodies[row + 9])
                - bodies[row + 1] * (bodies[row + 4] * bodies[row + 10] - bodies[row + 6] * bodies[row + 8])
                + bodies[row + 2] * (bodies[row + 4] * bodies[row + 9] - bodies[row + 5] * bodies[row + 8]);
        return determinant < 0f ? -1f : 1f;
    }

    /** Writes a vector of the mesh in world space, scaled so that its squares neither underflow nor overflow. */
    private static void write(float[] path, int at, int instance, float x, float y, float z, float[] bodies) {
        int row = instance + Layout.INSTANCE_TO_WORLD;
        float worldX = Instance.vector(bodies, row, x, y, z);
        float worldY = Instance.vector(bodies, row + 4, x, y, z);
        float worldZ = Instance.vector(bodies, row + 8, x, y, z);
        float largest = Math.max(Math.max(Math.abs(worldX), Math.abs(worldY)), Math.abs(worldZ));
        float scale = largest > 0f ? 1f / largest : 0f;
        path[at] = worldX * scale;
        path[at + 1] = worldY * scale;
        path[at + 2] = worldZ * scale;
    }
}
