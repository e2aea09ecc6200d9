package dev.twister.kernel;

/** The closest triangle of a ray. */
final class MeshHit {
    private MeshHit() {}

    /**
     * The closest body: the closest one so far, at {@link Layout#DISTANCE}, or a closer mesh; of surfaces in one place
     * the one that {@link Coincidence} prefers. The triangle that the ray leaves is ignored. Writes distance in meters,
     * instance and triangle.
     *
     * @param path {@link Layout#PATH_LENGTH} floats
     * @param closest the closest body so far
     * @param scratch {@link Layout#SCRATCH_LENGTH} floats
     */
    static int find(
            float[] path,
            int closest,
            float[] scratch,
            float[] frame,
            float[] bodies,
            float[] looks,
            float[] meshes,
            int variant) {
        float originX = path[Layout.ORIGIN];
        float originY = path[Layout.ORIGIN + 1];
        float originZ = path[Layout.ORIGIN + 2];
        float inverseX = NodeBox.inverse(path[Layout.DIRECTION]);
        float inverseY = NodeBox.inverse(path[Layout.DIRECTION + 1]);
        float inverseZ = NodeBox.inverse(path[Layout.DIRECTION + 2]);
        int nodes = (int) frame[Layout.INSTANCES] + 1;
        int hit = closest;
        float growth = NodeBox.growth(bodies, nodes, originX, originY, originZ);
        float rootEntry = NodeBox.entry(bodies, nodes, originX, originY, originZ, inverseX, inverseY, inverseZ, growth);
        int node = rootEntry <= path[Layout.DISTANCE] ? nodes : Layout.NO_NODE;
        int waiting = 0;
        Views.count(path, Views.TESTS, 1, variant);
        while (node != Layout.NO_NODE) {
            int link = (int) bodies[node + Layout.NODE_LINK];
            int count = (int) bodies[node + Layout.NODE_SPHERES];
            int next = Layout.NO_NODE;
            if (count < 0) {
                Views.count(path, Views.TESTS, 2, variant);
                int child = nodes + Layout.NODE_STRIDE * link;
                float left =
                        NodeBox.entry(bodies, child, originX, originY, originZ, inverseX, inverseY, inverseZ, growth);
                float right = NodeBox.entry(
                        bodies,
                        child + Layout.NODE_STRIDE,
                        originX,
                        originY,
                        originZ,
                        inverseX,
                        inverseY,
                        inverseZ,
                        growth);
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
            if (count == 0) {
                hit = inMesh(path, hit, link, scratch, frame, bodies, looks, meshes, variant);
            }
            if (count > 0) {
                hit = inSmall(path, hit, nodes + link, count, frame, bodies, looks, meshes, variant);
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
            float[] scratch,
            float[] frame,
            float[] bodies,
            float[] looks,
            float[] meshes,
            int variant) {
        int instance = Instance.at(number, (int) frame[Layout.INSTANCES], bodies);
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
        float x = path[Layout.MESH_ORIGIN];
        float y = path[Layout.MESH_ORIGIN + 1];
        float z = path[Layout.MESH_ORIGIN + 2];
        float inverseX = NodeBox.inverse(path[Layout.MESH_DIRECTION]);
        float inverseY = NodeBox.inverse(path[Layout.MESH_DIRECTION + 1]);
        float inverseZ = NodeBox.inverse(path[Layout.MESH_DIRECTION + 2]);
        int nodes = Instance.nodes(bodies, instance);
        int triangles = Instance.triangles(bodies, instance);
        touch(path, number, frame, bodies);
        int hit = closest;
        float distance = path[Layout.DISTANCE];
        float growth = NodeBox.growth(meshes, nodes, x, y, z);
        float rootEntry = NodeBox.entry(meshes, nodes, x, y, z, inverseX, inverseY, inverseZ, growth);
        int node = rootEntry <= distance ? nodes : Layout.NO_NODE;
        int waiting = 0;
        Views.count(path, Views.TESTS, 1, variant);
        while (node != Layout.NO_NODE) {
            int link = (int) meshes[node + Layout.NODE_LINK];
            int count = (int) meshes[node + Layout.NODE_SPHERES];
            int next = Layout.NO_NODE;
            Views.count(path, Views.TESTS, count < 0 ? 2 : count, variant);
            if (count < 0) {
                int child = nodes + Layout.NODE_STRIDE * link;
                float left = NodeBox.entry(meshes, child, x, y, z, inverseX, inverseY, inverseZ, growth);
                float right = NodeBox.entry(
                        meshes, child + Layout.NODE_STRIDE, x, y, z, inverseX, inverseY, inverseZ, growth);
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
                float met = Triangle.distance(path, triangles + Layout.TRIANGLE_STRIDE * (link + i), meshes);
                hit = meet(path, hit, met, number, link + i, frame, bodies, looks, meshes, variant);
            }
            distance = path[Layout.DISTANCE];
            while (((next == Layout.NO_NODE ? 1 : 0) & (waiting > 0 ? 1 : 0)) != 0) {
                waiting = waiting - 1;
                float entry = scratch[Layout.SCRATCH_RAY_NODES + 2 * waiting + 1];
                int kept = nodes + Layout.NODE_STRIDE * (int) scratch[Layout.SCRATCH_RAY_NODES + 2 * waiting];
                next = entry <= distance ? kept : Layout.NO_NODE;
            }
            node = next;
        }
        return hit;
    }

    /**
     * As above for a small mesh, in the world's coordinates.
     *
     * @param small its place
     * @param count number of its triangles
     */
    private static int inSmall(
            float[] path,
            int closest,
            int small,
            int count,
            float[] frame,
            float[] bodies,
            float[] looks,
            float[] meshes,
            int variant) {
        MeshRay.stay(
                path,
                small,
                path[Layout.ORIGIN],
                path[Layout.ORIGIN + 1],
                path[Layout.ORIGIN + 2],
                path[Layout.DIRECTION],
                path[Layout.DIRECTION + 1],
                path[Layout.DIRECTION + 2],
                bodies);
        int number = (int) bodies[small + Layout.SMALL_INSTANCE];
        touch(path, number, frame, bodies);
        int hit = closest;
        Views.count(path, Views.TESTS, count, variant);
        for (int i = 0; i < count; i++) {
            float met = Triangle.distance(path, small + Layout.SMALL_TRIANGLES + Layout.TRIANGLE_STRIDE * i, bodies);
            hit = meet(path, hit, met, number, i, frame, bodies, looks, meshes, variant);
        }
        return hit;
    }

    /** Makes a ray that has crossed another body's surface meet those of the instance in the same place. */
    private static void touch(float[] path, int number, float[] frame, float[] bodies) {
        int body = (int) bodies[Instance.at(number, (int) frame[Layout.INSTANCES], bodies) + Layout.INSTANCE_BODY];
        int crossed = (path[Layout.INSIDE] < 0f ? 1 : 0) | (path[Layout.INSIDE] > 1f ? 1 : 0);
        int meetsTouching = crossed & (body == (int) path[Layout.LEAVING] ? 0 : 1);
        path[Layout.MESH_REACH] = meetsTouching != 0 ? -path[Layout.MESH_REACH] : path[Layout.MESH_REACH];
    }

    /**
     * The closest body so far, or that of a triangle which replaces it.
     *
     * @param met distance to the triangle
     */
    private static int meet(
            float[] path,
            int closest,
            float met,
            int number,
            int triangle,
            float[] frame,
            float[] bodies,
            float[] looks,
            float[] meshes,
            int variant) {
        int hit = closest;
        float distance = path[Layout.DISTANCE];
        int near = (met <= distance * (1f + Coincidence.TOLERANCE) ? 1 : 0) & (met < Intersection.MISS ? 1 : 0);
        if (near != 0) {
            int instance = Instance.at(number, (int) frame[Layout.INSTANCES], bodies);
            int body = (int) bodies[instance + Layout.INSTANCE_BODY];
            int own = (body == (int) path[Layout.LEAVING] ? 1 : 0)
                    & (triangle == (int) path[Layout.LEAVING_TRIANGLE] ? 1 : 0);
            int candidate = 1 - own;
            if ((variant & Variant.MASKS) != 0) {
                if (candidate != 0) {
                    candidate = 1 - Opacity.lets(path, body, instance, triangle, frame, bodies, looks, meshes, variant);
                }
            }
            if (candidate != 0) {
                int taken = Coincidence.replaces(path, hit, distance, met, number, triangle, frame, bodies, meshes);
                if (taken != 0) {
                    hit = body;
                    path[Layout.DISTANCE] = met;
                    path[Layout.INSTANCE] = number;
                    path[Layout.TRIANGLE] = triangle;
                }
            }
        }
        return hit;
    }
}
