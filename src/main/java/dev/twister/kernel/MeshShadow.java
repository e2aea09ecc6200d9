package dev.twister.kernel;

/** The meshes' part of {@link Shadow}: the light that they transmit along a ray from a point to a light sample. */
final class MeshShadow {
    private MeshShadow() {}

    /**
     * 1 if a mesh may lie between {@link Layout#POINT} and the light's disc, because its box meets the cone between
     * them.
     *
     * @param path {@link Layout#PATH_LENGTH} floats, with the disc's axes
     * @param firstMesh the first mesh's body
     */
    static int mayBlock(float[] path, float[] hierarchy, int firstMesh, float[] scratch, int aspect) {
        float inverseX = NodeBox.inverse(path[Layout.TO_LIGHT]);
        float inverseY = NodeBox.inverse(path[Layout.TO_LIGHT + 1]);
        float inverseZ = NodeBox.inverse(path[Layout.TO_LIGHT + 2]);
        int nodes = Layout.instances(firstMesh) + 1;
        Aspect.count(path, aspect, Aspect.TESTS, 1);
        float rootEntry = NodeBox.coneEntry(path, hierarchy, nodes, inverseX, inverseY, inverseZ);
        int node = rootEntry < NodeBox.PASSED ? nodes : Layout.NO_NODE;
        int waiting = 0;
        int met = 0;
        while (node != Layout.NO_NODE) {
            int next = Layout.NO_NODE;
            if (hierarchy[node + Layout.NODE_SPHERES] < 0f) {
                Aspect.count(path, aspect, Aspect.TESTS, 2);
                int child = nodes + Layout.NODE_STRIDE * (int) hierarchy[node + Layout.NODE_LINK];
                int other = child + Layout.NODE_STRIDE;
                float first = NodeBox.coneEntry(path, hierarchy, child, inverseX, inverseY, inverseZ);
                float second = NodeBox.coneEntry(path, hierarchy, other, inverseX, inverseY, inverseZ);
                int both = (first < NodeBox.PASSED ? 1 : 0) & (second < NodeBox.PASSED ? 1 : 0);
                if (both != 0) {
                    scratch[Layout.SCRATCH_STACK + waiting] = (int) hierarchy[node + Layout.NODE_LINK] + 1;
                    waiting = waiting + 1;
                }
                int only = second < NodeBox.PASSED ? other : Layout.NO_NODE;
                next = first < NodeBox.PASSED ? child : only;
            } else {
                met = 1;
            }
            if (((next == Layout.NO_NODE ? 1 : 0) & (waiting > 0 ? 1 : 0)) != 0) {
                waiting = waiting - 1;
                next = nodes + Layout.NODE_STRIDE * (int) scratch[Layout.SCRATCH_STACK + waiting];
            }
            node = met == 0 ? next : Layout.NO_NODE;
        }
        return met;
    }

    /**
     * The light in [0, 1] that the meshes transmit along the ray through (1, x, y) * distance, in the frame of A, U
     * (with x = 0) and W; 0 if an opaque one blocks it. The triangle that the point lies on is ignored.
     *
     * @param own the body that the point lies on
     */
    static float light(
            float[] path,
            int own,
            float x,
            float y,
            float[] looks,
            float[] hierarchy,
            float[] meshes,
            int firstMesh,
            float[] scratch,
            int materials,
            int aspect) {
        float distance = path[Layout.LIGHT_DISTANCE];
        float pointX = path[Layout.POINT];
        float pointY = path[Layout.POINT + 1];
        float pointZ = path[Layout.POINT + 2];
        float directionX = distance * (path[Layout.TO_LIGHT] + path[Layout.DISC_W] * y);
        float directionY =
                distance * (path[Layout.TO_LIGHT + 1] + path[Layout.DISC_U_Y] * x + path[Layout.DISC_W + 1] * y);
        float directionZ =
                distance * (path[Layout.TO_LIGHT + 2] + path[Layout.DISC_U_Z] * x + path[Layout.DISC_W + 2] * y);
        float inverseX = NodeBox.inverse(directionX);
        float inverseY = NodeBox.inverse(directionY);
        float inverseZ = NodeBox.inverse(directionZ);
        int nodes = Layout.instances(firstMesh) + 1;
        float light = 1f;
        int node = nodes;
        int waiting = 0;
        while (node != Layout.NO_NODE) {
            int link = (int) hierarchy[node + Layout.NODE_LINK];
            int count = (int) hierarchy[node + Layout.NODE_SPHERES];
            int next = Layout.NO_NODE;
            if (count < 0) {
                Aspect.count(path, aspect, Aspect.TESTS, 2);
                int child = nodes + Layout.NODE_STRIDE * link;
                float first = NodeBox.entry(hierarchy, child, pointX, pointY, pointZ, inverseX, inverseY, inverseZ);
                float second = NodeBox.entry(
                        hierarchy, child + Layout.NODE_STRIDE, pointX, pointY, pointZ, inverseX, inverseY, inverseZ);
                int both = (first <= 1f ? 1 : 0) & (second <= 1f ? 1 : 0);
                if (both != 0) {
                    scratch[Layout.SCRATCH_STACK + waiting] = link + 1;
                    waiting = waiting + 1;
                }
                int only = second <= 1f ? child + Layout.NODE_STRIDE : Layout.NO_NODE;
                next = first <= 1f ? child : only;
            }
            int lit = light > 0f ? 1 : 0;
            for (int i = 0; i < count && lit != 0; i++) {
                int instance = Instance.at(hierarchy, firstMesh, link + i);
                int body = (int) hierarchy[instance + Layout.INSTANCE_BODY];
                int met = isMet(
                        path,
                        instance,
                        body == own ? (int) path[Layout.LEAVING_TRIANGLE] : Layout.NOTHING,
                        directionX,
                        directionY,
                        directionZ,
                        hierarchy,
                        meshes,
                        scratch,
                        aspect);
                light = met != 0 ? light * Shadow.transmission(looks, body, materials) : light;
                lit = light > 0f ? 1 : 0;
            }
            if (((next == Layout.NO_NODE ? 1 : 0) & (waiting > 0 ? 1 : 0)) != 0) {
                waiting = waiting - 1;
                next = nodes + Layout.NODE_STRIDE * (int) scratch[Layout.SCRATCH_STACK + waiting];
            }
            node = light > 0f ? next : Layout.NO_NODE;
        }
        return light;
    }

    /** 1 if any triangle of the instance except the ignored one lies between the point and the end of the direction. */
    private static int isMet(
            float[] path,
            int instance,
            int ignored,
            float worldX,
            float worldY,
            float worldZ,
            float[] hierarchy,
            float[] meshes,
            float[] scratch,
            int aspect) {
        int row = instance + Layout.INSTANCE_TO_MESH;
        float pointX = path[Layout.POINT];
        float pointY = path[Layout.POINT + 1];
        float pointZ = path[Layout.POINT + 2];
        float x = Instance.point(hierarchy, row, pointX, pointY, pointZ);
        float y = Instance.point(hierarchy, row + 4, pointX, pointY, pointZ);
        float z = Instance.point(hierarchy, row + 8, pointX, pointY, pointZ);
        float directionX = Instance.vector(hierarchy, row, worldX, worldY, worldZ);
        float directionY = Instance.vector(hierarchy, row + 4, worldX, worldY, worldZ);
        float directionZ = Instance.vector(hierarchy, row + 8, worldX, worldY, worldZ);
        float inverseX = NodeBox.inverse(directionX);
        float inverseY = NodeBox.inverse(directionY);
        float inverseZ = NodeBox.inverse(directionZ);
        int nodes = Instance.nodes(hierarchy, instance);
        int triangles = Instance.triangles(hierarchy, instance);
        int axis = Triangle.longestAxis(directionX, directionY, directionZ);
        int firstAxis = Triangle.after(axis);
        int secondAxis = Triangle.after(firstAxis);
        float first = Triangle.along(firstAxis, x, y, z);
        float second = Triangle.along(secondAxis, x, y, z);
        float third = Triangle.along(axis, x, y, z);
        float inverse = 1f / Triangle.along(axis, directionX, directionY, directionZ);
        float shearFirst = Triangle.along(firstAxis, directionX, directionY, directionZ) * inverse;
        float shearSecond = Triangle.along(secondAxis, directionX, directionY, directionZ) * inverse;
        Aspect.count(path, aspect, Aspect.TESTS, 1);
        int node = NodeBox.entry(meshes, nodes, x, y, z, inverseX, inverseY, inverseZ) <= 1f ? nodes : Layout.NO_NODE;
        int waiting = 0;
        int met = 0;
        while (node != Layout.NO_NODE) {
            int link = (int) meshes[node + Layout.NODE_LINK];
            int count = (int) meshes[node + Layout.NODE_SPHERES];
            int next = Layout.NO_NODE;
            Aspect.count(path, aspect, Aspect.TESTS, count < 0 ? 2 : count);
            if (count < 0) {
                int child = nodes + Layout.NODE_STRIDE * link;
                float left = NodeBox.entry(meshes, child, x, y, z, inverseX, inverseY, inverseZ);
                float right = NodeBox.entry(meshes, child + Layout.NODE_STRIDE, x, y, z, inverseX, inverseY, inverseZ);
                int both = (left <= 1f ? 1 : 0) & (right <= 1f ? 1 : 0);
                if (both != 0) {
                    scratch[Layout.SCRATCH_SHADOW_NODES + waiting] = link + 1;
                    waiting = waiting + 1;
                }
                int only = right <= 1f ? child + Layout.NODE_STRIDE : Layout.NO_NODE;
                next = left <= 1f ? child : only;
            }
            for (int i = 0; i < count; i++) {
                float distance = Triangle.distance(
                        meshes,
                        triangles + Layout.TRIANGLE_STRIDE * (link + i),
                        axis,
                        first,
                        second,
                        third,
                        shearFirst,
                        shearSecond,
                        inverse);
                met = met | ((distance < 1f ? 1 : 0) & (link + i != ignored ? 1 : 0));
            }
            if (((next == Layout.NO_NODE ? 1 : 0) & (waiting > 0 ? 1 : 0)) != 0) {
                waiting = waiting - 1;
                next = nodes + Layout.NODE_STRIDE * (int) scratch[Layout.SCRATCH_SHADOW_NODES + waiting];
            }
            node = met == 0 ? next : Layout.NO_NODE;
        }
        return met;
    }
}
