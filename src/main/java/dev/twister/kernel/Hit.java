package dev.twister.kernel;

/** The closest hit of a ray. */
public final class Hit {
    /**
     * Values of the argument {@code search}: a loop over all bodies, or a traversal of the spheres' hierarchy. Both
     * find the same hit.
     */
    public static final int ALL = 0;

    public static final int WALK = 1;

    private Hit() {}

    /**
     * The closest body in front of the path's ray, the lower number on a tie; {@link Layout#NOTHING} for a miss. It
     * ignores the body that the ray leaves, or of a mesh only the triangle. Writes the distance in meters to
     * {@link Layout#DISTANCE}.
     *
     * @param path {@link Layout#PATH_LENGTH} floats
     * @param places {@link Layout#PLACE_STRIDE} floats per body
     * @param looks {@link Layout#LOOK_STRIDE} floats per body
     * @param hierarchy hierarchies over the spheres and the meshes
     * @param meshes all meshes, see {@link Layout}
     * @param bodies number of bodies without meshes
     * @param scratch {@link Layout#SCRATCH_LENGTH} floats
     * @param search {@link #ALL} or {@link #WALK}
     * @param firstMesh the first mesh's body, or {@link Layout#NO_MESHES}
     * @param materials {@link Material#PLAIN} or {@link Material#ANY}
     * @param aspect a constant of {@link Aspect}
     */
    public static int find(
            float[] path,
            float[] places,
            float[] looks,
            float[] hierarchy,
            float[] meshes,
            int bodies,
            float[] scratch,
            int search,
            int firstMesh,
            int materials,
            int aspect) {
        int body = amongFirst(path, places, looks, search == WALK ? Layout.FIRST_SPHERE : bodies, materials, aspect);
        if (search == WALK) {
            body = onWalk(path, body, looks, hierarchy, Layout.root(bodies), scratch, materials, aspect);
        }
        if (firstMesh > Layout.NO_MESHES) {
            body = MeshHit.find(path, body, hierarchy, meshes, firstMesh, scratch, aspect);
        }
        return body;
    }

    /** The body that the ray ignores: the one that it leaves, unless it continues inside. */
    private static int ignored(float[] path, int materials) {
        int leaving = (int) path[Layout.LEAVING];
        if (materials == Material.ANY) {
            leaving = path[Layout.INSIDE] > 0f ? Layout.NOTHING : leaving;
        }
        return leaving;
    }

    private static int amongFirst(float[] path, float[] places, float[] looks, int count, int materials, int aspect) {
        int ignored = ignored(path, materials);
        float closest = Intersection.MISS;
        int hit = Layout.NOTHING;
        for (int body = 0; body < count; body++) {
            if (body != ignored) {
                Aspect.count(path, aspect, Aspect.TESTS, 1);
                float distance = distance(path, body, places, looks, materials);
                hit = distance < closest ? body : hit;
                closest = distance < closest ? distance : closest;
            }
        }
        path[Layout.DISTANCE] = closest;
        return hit;
    }

    private static float distance(float[] path, int body, float[] places, float[] looks, int materials) {
        int place = Layout.PLACE_STRIDE * body;
        float distance;
        if (body == Layout.PLANE) {
            distance = Intersection.plane(
                    places[place + 1],
                    places[place + Layout.PLACE_SIZE],
                    path[Layout.ORIGIN] - places[place],
                    path[Layout.ORIGIN + 1],
                    path[Layout.ORIGIN + 2] - places[place + 2],
                    path[Layout.DIRECTION],
                    path[Layout.DIRECTION + 1],
                    path[Layout.DIRECTION + 2]);
        } else {
            distance = sphere(path, places, place, body, looks, materials);
        }
        return distance;
    }

    /** Distance to a sphere given by center and radius in an array. Transmitting spheres are also hit from inside. */
    private static float sphere(float[] path, float[] spheres, int at, int body, float[] looks, int materials) {
        float x = spheres[at] - path[Layout.ORIGIN];
        float y = spheres[at + 1] - path[Layout.ORIGIN + 1];
        float z = spheres[at + 2] - path[Layout.ORIGIN + 2];
        float radius = spheres[at + Layout.PLACE_SIZE];
        float directionX = path[Layout.DIRECTION];
        float directionY = path[Layout.DIRECTION + 1];
        float directionZ = path[Layout.DIRECTION + 2];
        float distance = Intersection.sphere(x, y, z, radius, directionX, directionY, directionZ);
        if (materials == Material.ANY) {
            int own = body == (int) path[Layout.LEAVING] ? 1 : 0;
            int transmits = looks[Layout.LOOK_STRIDE * body + Layout.LOOK_TRANSMISSION] > 0f ? 1 : 0;
            if ((transmits & (own | (distance == Intersection.MISS ? 1 : 0))) != 0) {
                distance = Intersection.sphereFromInside(x, y, z, radius, directionX, directionY, directionZ);
            }
        }
        return distance;
    }

    /**
     * Traverses the hierarchy, the nearer child first; skips nodes beyond the closest hit so far.
     *
     * @param first the closest hit so far
     * @param root place of the root in the hierarchy
     */
    private static int onWalk(
            float[] path,
            int first,
            float[] looks,
            float[] hierarchy,
            int root,
            float[] scratch,
            int materials,
            int aspect) {
        float originX = path[Layout.ORIGIN];
        float originY = path[Layout.ORIGIN + 1];
        float originZ = path[Layout.ORIGIN + 2];
        float inverseX = NodeBox.inverse(path[Layout.DIRECTION]);
        float inverseY = NodeBox.inverse(path[Layout.DIRECTION + 1]);
        float inverseZ = NodeBox.inverse(path[Layout.DIRECTION + 2]);
        int hit = first;
        int node = root;
        int waiting = 0;
        while (node != Layout.NO_NODE) {
            int link = (int) hierarchy[node + Layout.NODE_LINK];
            int spheres = (int) hierarchy[node + Layout.NODE_SPHERES];
            int next = Layout.NO_NODE;
            Aspect.count(path, aspect, Aspect.TESTS, spheres < 0 ? 2 : spheres);
            if (spheres < 0) {
                float left = NodeBox.entry(hierarchy, link, originX, originY, originZ, inverseX, inverseY, inverseZ);
                float right = NodeBox.entry(
                        hierarchy, link + Layout.NODE_STRIDE, originX, originY, originZ, inverseX, inverseY, inverseZ);
                int swapped = right < left ? Layout.NODE_STRIDE : 0;
                float near = right < left ? right : left;
                float far = right < left ? left : right;
                if (far <= path[Layout.DISTANCE]) {
                    scratch[Layout.SCRATCH_STACK + 2 * waiting] = link + Layout.NODE_STRIDE - swapped;
                    scratch[Layout.SCRATCH_STACK + 2 * waiting + 1] = far;
                    waiting = waiting + 1;
                }
                next = near <= path[Layout.DISTANCE] ? link + swapped : Layout.NO_NODE;
            }
            hit = inLeaf(path, hit, looks, hierarchy, link, spheres, materials);
            while (((next == Layout.NO_NODE ? 1 : 0) & (waiting > 0 ? 1 : 0)) != 0) {
                waiting = waiting - 1;
                float entry = scratch[Layout.SCRATCH_STACK + 2 * waiting + 1];
                next = entry <= path[Layout.DISTANCE]
                        ? (int) scratch[Layout.SCRATCH_STACK + 2 * waiting]
                        : Layout.NO_NODE;
            }
            node = next;
        }
        return hit;
    }

    /** The closest hit so far, or a closer sphere of the leaf. */
    private static int inLeaf(
            float[] path, int first, float[] looks, float[] hierarchy, int link, int spheres, int materials) {
        int ignored = ignored(path, materials);
        float closest = path[Layout.DISTANCE];
        int hit = first;
        for (int sphere = 0; sphere < spheres; sphere++) {
            int at = link + Layout.SPHERE_STRIDE * sphere;
            int body = (int) hierarchy[at + Layout.SPHERE_BODY];
            float distance = sphere(path, hierarchy, at, body, looks, materials);
            if (distance <= closest) {
                int closer = (distance < closest ? 1 : 0) | (body < hit ? 1 : 0);
                int taken = closer & (body != ignored ? 1 : 0);
                hit = taken != 0 ? body : hit;
                closest = taken != 0 ? distance : closest;
            }
        }
        path[Layout.DISTANCE] = closest;
        return hit;
    }
}
