package dev.twister.kernel;

/** The closest triangle of a ray. */
final class MeshHit {
    private MeshHit() {}

    /**
     * The closest body: the closest one so far, at {@link Layout#DISTANCE}, or a closer mesh; on a tie the lower body
     * and the lower triangle. The triangle that the ray leaves is ignored. Writes distance in meters, instance and
     * triangle.
     *
     * @param path {@link Layout#PATH_LENGTH} floats
     * @param closest the closest body so far
     * @param firstMesh the first mesh's body
     * @param scratch {@link Layout#SCRATCH_LENGTH} floats
     * @param aspect a constant of {@link Aspect}
     */
    static int find(
            float[] path, int closest, float[] hierarchy, float[] meshes, int firstMesh, float[] scratch, int aspect) {
        float originX = path[Layout.ORIGIN];
        float originY = path[Layout.ORIGIN + 1];
        float originZ = path[Layout.ORIGIN + 2];
        float inverseX = NodeBox.inverse(path[Layout.DIRECTION]);
        float inverseY = NodeBox.inverse(path[Layout.DIRECTION + 1]);
        float inverseZ = NodeBox.inverse(path[Layout.DIRECTION + 2]);
        int nodes = Layout.instances(firstMesh) + 1;
        int hit = closest;
        float rootEntry = NodeBox.entry(hierarchy, nodes, originX, originY, originZ, inverseX, inverseY, inverseZ);
        int node = rootEntry <= path[Layout.DISTANCE] ? nodes : Layout.NO_NODE;
        int waiting = 0;
        Aspect.count(path, aspect, Aspect.TESTS, 1);
        while (node != Layout.NO_NODE) {
            int link = (int) hierarchy[node + Layout.NODE_LINK];
            int count = (int) hierarchy[node + Layout.NODE_SPHERES];
            int next = Layout.NO_NODE;
            if (count < 0) {
                Aspect.count(path, aspect, Aspect.TESTS, 2);
                int child = nodes + Layout.NODE_STRIDE * link;
                float left = NodeBox.entry(hierarchy, child, originX, originY, originZ, inverseX, inverseY, inverseZ);
                float right = NodeBox.entry(
                        hierarchy, child + Layout.NODE_STRIDE, originX, originY, originZ, inverseX, inverseY, inverseZ);
                int swapped = right < left ? 1 : 0;
                float near = right < left ? right : left;
                float far = right < left ? left : right;
                if (far <= path[Layout.DISTANCE]) {
                    scratch[Layout.SCRATCH_STACK + 2 * waiting] = link + 1 - swapped;
                    scratch[Layout.SCRATCH_STACK + 2 * waiting + 1] = far;
                    waiting = waiting + 1;
                }
                next = near <= path[Layout.DISTANCE] ? child + Layout.NODE_STRIDE * swapped : Layout.NO_NODE;
            }
            for (int i = 0; i < count; i++) {
                hit = inMesh(path, hit, link + i, hierarchy, meshes, firstMesh, scratch, aspect);
            }
            while (((next == Layout.NO_NODE ? 1 : 0) & (waiting > 0 ? 1 : 0)) != 0) {
                waiting = waiting - 1;
                float entry = scratch[Layout.SCRATCH_STACK + 2 * waiting + 1];
                int kept = nodes + Layout.NODE_STRIDE * (int) scratch[Layout.SCRATCH_STACK + 2 * waiting];
                next = entry <= path[Layout.DISTANCE] ? kept : Layout.NO_NODE;
            }
            node = next;
        }
        return hit;
    }

    /** As above for one instance, in its mesh's coordinates. Distances remain those of the world. */
    private static int inMesh(
            float[] path,
            int closest,
            int number,
            float[] hierarchy,
            float[] meshes,
            int firstMesh,
            float[] scratch,
            int aspect) {
        int instance = Instance.at(hierarchy, firstMesh, number);
        int row = instance + Layout.INSTANCE_TO_MESH;
        float worldX = path[Layout.ORIGIN];
        float worldY = path[Layout.ORIGIN + 1];
        float worldZ = path[Layout.ORIGIN + 2];
        float x = Instance.point(hierarchy, row, worldX, worldY, worldZ);
        float y = Instance.point(hierarchy, row + 4, worldX, worldY, worldZ);
        float z = Instance.point(hierarchy, row + 8, worldX, worldY, worldZ);
        float alongX = path[Layout.DIRECTION];
        float alongY = path[Layout.DIRECTION + 1];
        float alongZ = path[Layout.DIRECTION + 2];
        float directionX = Instance.vector(hierarchy, row, alongX, alongY, alongZ);
        float directionY = Instance.vector(hierarchy, row + 4, alongX, alongY, alongZ);
        float directionZ = Instance.vector(hierarchy, row + 8, alongX, alongY, alongZ);
        float inverseX = NodeBox.inverse(directionX);
        float inverseY = NodeBox.inverse(directionY);
        float inverseZ = NodeBox.inverse(directionZ);
        int nodes = Instance.nodes(hierarchy, instance);
        int triangles = Instance.triangles(hierarchy, instance);
        int body = (int) hierarchy[instance + Layout.INSTANCE_BODY];
        int ignored = body == (int) path[Layout.LEAVING] ? (int) path[Layout.LEAVING_TRIANGLE] : Layout.NOTHING;
        int axis = Triangle.longestAxis(directionX, directionY, directionZ);
        int firstAxis = Triangle.after(axis);
        int secondAxis = Triangle.after(firstAxis);
        float first = Triangle.along(firstAxis, x, y, z);
        float second = Triangle.along(secondAxis, x, y, z);
        float third = Triangle.along(axis, x, y, z);
        float inverse = 1f / Triangle.along(axis, directionX, directionY, directionZ);
        float shearFirst = Triangle.along(firstAxis, directionX, directionY, directionZ) * inverse;
        float shearSecond = Triangle.along(secondAxis, directionX, directionY, directionZ) * inverse;
        int hit = closest;
        float distance = path[Layout.DISTANCE];
        float rootEntry = NodeBox.entry(meshes, nodes, x, y, z, inverseX, inverseY, inverseZ);
        int node = rootEntry <= distance ? nodes : Layout.NO_NODE;
        int waiting = 0;
        Aspect.count(path, aspect, Aspect.TESTS, 1);
        while (node != Layout.NO_NODE) {
            int link = (int) meshes[node + Layout.NODE_LINK];
            int count = (int) meshes[node + Layout.NODE_SPHERES];
            int next = Layout.NO_NODE;
            Aspect.count(path, aspect, Aspect.TESTS, count < 0 ? 2 : count);
            if (count < 0) {
                int child = nodes + Layout.NODE_STRIDE * link;
                float left = NodeBox.entry(meshes, child, x, y, z, inverseX, inverseY, inverseZ);
                float right = NodeBox.entry(meshes, child + Layout.NODE_STRIDE, x, y, z, inverseX, inverseY, inverseZ);
                int swapped = right < left ? 1 : 0;
                float near = right < left ? right : left;
                float far = right < left ? left : right;
                if (far <= distance) {
                    scratch[Layout.SCRATCH_RAY_NODES + 2 * waiting] = link + 1 - swapped;
                    scratch[Layout.SCRATCH_RAY_NODES + 2 * waiting + 1] = far;
                    waiting = waiting + 1;
                }
                next = near <= distance ? child + Layout.NODE_STRIDE * swapped : Layout.NO_NODE;
            }
            for (int i = 0; i < count; i++) {
                int triangle = link + i;
                float met = Triangle.distance(
                        meshes,
                        triangles + Layout.TRIANGLE_STRIDE * triangle,
                        axis,
                        first,
                        second,
                        third,
                        shearFirst,
                        shearSecond,
                        inverse);
                if (met <= distance) {
                    int lower = (body < hit ? 1 : 0)
                            | ((body == hit ? 1 : 0) & (triangle < (int) path[Layout.TRIANGLE] ? 1 : 0));
                    int taken = (triangle != ignored ? 1 : 0) & ((met < distance ? 1 : 0) | lower);
                    if (taken != 0) {
                        hit = body;
                        distance = met;
                        path[Layout.INSTANCE] = number;
                        path[Layout.TRIANGLE] = triangle;
                    }
                }
            }
            while (((next == Layout.NO_NODE ? 1 : 0) & (waiting > 0 ? 1 : 0)) != 0) {
                waiting = waiting - 1;
                float entry = scratch[Layout.SCRATCH_RAY_NODES + 2 * waiting + 1];
                int kept = nodes + Layout.NODE_STRIDE * (int) scratch[Layout.SCRATCH_RAY_NODES + 2 * waiting];
                next = entry <= distance ? kept : Layout.NO_NODE;
            }
            node = next;
        }
        path[Layout.DISTANCE] = distance;
        return hit;
    }
}
