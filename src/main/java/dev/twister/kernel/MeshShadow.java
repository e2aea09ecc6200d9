package dev.twister.kernel;

/** The meshes' part of {@link Shadow}: the light that they transmit along a ray from a point to a light sample. */
final class MeshShadow {
    private MeshShadow() {}

    /**
     * 1 if a mesh may lie between {@link Layout#POINT} and the light's disc, because its box meets the cone between
     * them.
     *
     * @param path {@link Layout#PATH_LENGTH} floats, with the disc's axes
     */
    static int mayBlock(float[] path, float[] scratch, float[] frame, float[] bodies, int variant) {
        float axisX = path[Layout.TO_LIGHT];
        float axisY = path[Layout.TO_LIGHT + 1];
        float axisZ = path[Layout.TO_LIGHT + 2];
        float tangent = path[Layout.DISC_TANGENT];
        float spreadX = NodeBox.spread(axisY, axisZ, tangent);
        float spreadY = NodeBox.spread(axisZ, axisX, tangent);
        float spreadZ = NodeBox.spread(axisX, axisY, tangent);
        float leastX = NodeBox.inverse(axisX - spreadX);
        float leastY = NodeBox.inverse(axisY - spreadY);
        float leastZ = NodeBox.inverse(axisZ - spreadZ);
        float greatestX = NodeBox.inverse(axisX + spreadX);
        float greatestY = NodeBox.inverse(axisY + spreadY);
        float greatestZ = NodeBox.inverse(axisZ + spreadZ);
        float end = path[Layout.LIGHT_DISTANCE] * Shadow.RELATIVE_MARGIN;
        int nodes = (int) frame[Layout.INSTANCES] + 1;
        Views.count(path, Views.TESTS, 1, variant);
        float growth = NodeBox.coneGrowth(path, bodies, nodes);
        float rootEntry =
                NodeBox.coneEntry(path, bodies, nodes, leastX, leastY, leastZ, greatestX, greatestY, greatestZ, growth);
        int node = rootEntry < end ? nodes : Layout.NO_NODE;
        int waiting = 0;
        int met = 0;
        while (node != Layout.NO_NODE) {
            int next = Layout.NO_NODE;
            if (bodies[node + Layout.NODE_SPHERES] < 0f) {
                Views.count(path, Views.TESTS, 2, variant);
                int child = nodes + Layout.NODE_STRIDE * (int) bodies[node + Layout.NODE_LINK];
                int other = child + Layout.NODE_STRIDE;
                float first = NodeBox.coneEntry(
                        path, bodies, child, leastX, leastY, leastZ, greatestX, greatestY, greatestZ, growth);
                float second = NodeBox.coneEntry(
                        path, bodies, other, leastX, leastY, leastZ, greatestX, greatestY, greatestZ, growth);
                int both = (first < end ? 1 : 0) & (second < end ? 1 : 0);
                if (both != 0) {
                    scratch[Layout.SCRATCH_SHADOW_STACK + waiting] = (int) bodies[node + Layout.NODE_LINK] + 1;
                    waiting = waiting + 1;
                }
                int only = second < end ? other : Layout.NO_NODE;
                next = first < end ? child : only;
            } else {
                met = 1;
            }
            if (((next == Layout.NO_NODE ? 1 : 0) & (waiting > 0 ? 1 : 0)) != 0) {
                waiting = waiting - 1;
                next = nodes + Layout.NODE_STRIDE * (int) scratch[Layout.SCRATCH_SHADOW_STACK + waiting];
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
            float[] scratch,
            float[] frame,
            float[] bodies,
            float[] looks,
            float[] meshes,
            int variant) {
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
        int nodes = (int) frame[Layout.INSTANCES] + 1;
        float growth = NodeBox.growth(bodies, nodes, pointX, pointY, pointZ);
        float light = 1f;
        int node = nodes;
        int waiting = 0;
        while (node != Layout.NO_NODE) {
            int link = (int) bodies[node + Layout.NODE_LINK];
            int count = (int) bodies[node + Layout.NODE_SPHERES];
            int next = Layout.NO_NODE;
            if (count < 0) {
                Views.count(path, Views.TESTS, 2, variant);
                int child = nodes + Layout.NODE_STRIDE * link;
                float first =
                        NodeBox.entry(bodies, child, pointX, pointY, pointZ, inverseX, inverseY, inverseZ, growth);
                float second = NodeBox.entry(
                        bodies,
                        child + Layout.NODE_STRIDE,
                        pointX,
                        pointY,
                        pointZ,
                        inverseX,
                        inverseY,
                        inverseZ,
                        growth);
                int both = (first <= 1f ? 1 : 0) & (second <= 1f ? 1 : 0);
                if (both != 0) {
                    scratch[Layout.SCRATCH_SHADOW_STACK + waiting] = link + 1;
                    waiting = waiting + 1;
                }
                int only = second <= 1f ? child + Layout.NODE_STRIDE : Layout.NO_NODE;
                next = first <= 1f ? child : only;
            }
            int lit = light > 0f ? 1 : 0;
            if ((lit & (count == 0 ? 1 : 0)) != 0) {
                int instance = Instance.at(link, (int) frame[Layout.INSTANCES], bodies);
                int body = (int) bodies[instance + Layout.INSTANCE_BODY];
                MeshRay.enter(path, instance, pointX, pointY, pointZ, directionX, directionY, directionZ, bodies);
                int ignored = body == own ? (int) path[Layout.LEAVING_TRIANGLE] : Layout.NOTHING;
                light = light * passed(path, body, instance, ignored, scratch, frame, bodies, looks, meshes, variant);
            }
            if ((lit & (count > 0 ? 1 : 0)) != 0) {
                int small = nodes + link;
                MeshRay.stay(path, small, pointX, pointY, pointZ, directionX, directionY, directionZ, bodies);
                light = blocks(path, own, small, count, frame, bodies, variant) != 0 ? 0f : light;
            }
            if (((next == Layout.NO_NODE ? 1 : 0) & (waiting > 0 ? 1 : 0)) != 0) {
                waiting = waiting - 1;
                next = nodes + Layout.NODE_STRIDE * (int) scratch[Layout.SCRATCH_SHADOW_STACK + waiting];
            }
            node = light > 0f ? next : Layout.NO_NODE;
        }
        return light;
    }

    /**
     * The part of the light in [0, 1] that passes an instance. Any triangle except the ignored one, between the point
     * and the end of the direction, leaves the body's transmission; each triangle of one that is not opaque leaves what
     * it lets through.
     */
    private static float passed(
            float[] path,
            int body,
            int instance,
            int ignored,
            float[] scratch,
            float[] frame,
            float[] bodies,
            float[] looks,
            float[] meshes,
            int variant) {
        float x = path[Layout.MESH_ORIGIN];
        float y = path[Layout.MESH_ORIGIN + 1];
        float z = path[Layout.MESH_ORIGIN + 2];
        float inverseX = NodeBox.inverse(path[Layout.MESH_DIRECTION]);
        float inverseY = NodeBox.inverse(path[Layout.MESH_DIRECTION + 1]);
        float inverseZ = NodeBox.inverse(path[Layout.MESH_DIRECTION + 2]);
        int nodes = Instance.nodes(bodies, instance);
        int triangles = Instance.triangles(bodies, instance);
        Views.count(path, Views.TESTS, 1, variant);
        float growth = NodeBox.growth(meshes, nodes, x, y, z);
        float rootEntry = NodeBox.entry(meshes, nodes, x, y, z, inverseX, inverseY, inverseZ, growth);
        int node = rootEntry <= 1f ? nodes : Layout.NO_NODE;
        int waiting = 0;
        int met = 0;
        float through = 1f;
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
                int both = (left <= 1f ? 1 : 0) & (right <= 1f ? 1 : 0);
                if (both != 0) {
                    scratch[Layout.SCRATCH_SHADOW_NODES + waiting] = link + 1;
                    waiting = waiting + 1;
                }
                int only = right <= 1f ? child + Layout.NODE_STRIDE : Layout.NO_NODE;
                next = left <= 1f ? child : only;
            }
            for (int i = 0; i < count; i++) {
                float distance = Triangle.distance(path, triangles + Layout.TRIANGLE_STRIDE * (link + i), meshes);
                int between = (distance < 1f ? 1 : 0) & (link + i != ignored ? 1 : 0);
                if ((variant & Variant.MASKS) != 0) {
                    if (between != 0) {
                        float opening = Opacity.passed(path, body, instance, link + i, frame, bodies, looks, meshes);
                        through = through * opening;
                        between = opening > 0f ? 0 : 1;
                    }
                }
                met = met | between;
            }
            if (((next == Layout.NO_NODE ? 1 : 0) & (waiting > 0 ? 1 : 0)) != 0) {
                waiting = waiting - 1;
                next = nodes + Layout.NODE_STRIDE * (int) scratch[Layout.SCRATCH_SHADOW_NODES + waiting];
            }
            node = met == 0 ? next : Layout.NO_NODE;
        }
        return met != 0 ? Shadow.transmission(body, looks, variant) : through;
    }

    /** 1 if any triangle of a small mesh, but the ignored one, lies between the point and the end of the direction. */
    private static int blocks(float[] path, int own, int small, int count, float[] frame, float[] bodies, int variant) {
        int instance = Instance.at((int) bodies[small + Layout.SMALL_INSTANCE], (int) frame[Layout.INSTANCES], bodies);
        int body = (int) bodies[instance + Layout.INSTANCE_BODY];
        int ignored = body == own ? (int) path[Layout.LEAVING_TRIANGLE] : Layout.NOTHING;
        int met = 0;
        Views.count(path, Views.TESTS, count, variant);
        for (int i = 0; i < count; i++) {
            float distance =
                    Triangle.distance(path, small + Layout.SMALL_TRIANGLES + Layout.TRIANGLE_STRIDE * i, bodies);
            met = met | ((distance < 1f ? 1 : 0) & (i != ignored ? 1 : 0));
        }
        return met;
    }
}
