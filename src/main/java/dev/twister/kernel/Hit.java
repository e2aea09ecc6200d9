package dev.twister.kernel;

/** The closest hit of a ray. */
public final class Hit {
    private Hit() {}

    /**
     * The closest body in front of the path's ray, the lower number on a tie; {@link Layout#NOTHING} for a miss. It
     * ignores the body that the ray leaves, or of a mesh only the triangle. Writes the distance in meters to
     * {@link Layout#DISTANCE}.
     *
     * @param path {@link Layout#PATH_LENGTH} floats
     * @param scratch {@link Layout#SCRATCH_LENGTH} floats
     */
    public static int find(
            float[] path, float[] scratch, float[] frame, float[] bodies, float[] looks, float[] meshes, int variant) {
        return within(path, Intersection.MISS, scratch, frame, bodies, looks, meshes, variant);
    }

    /**
     * As above, but only what is nearer than a limit.
     *
     * @param limit in meters
     */
    public static int within(
            float[] path,
            float limit,
            float[] scratch,
            float[] frame,
            float[] bodies,
            float[] looks,
            float[] meshes,
            int variant) {
        int body = amongFirst(
                path,
                limit,
                (variant & Variant.WALK) != 0 ? Layout.FIRST_SPHERE : (int) frame[Layout.BODIES],
                frame,
                bodies,
                looks,
                variant);
        if ((variant & Variant.WALK) != 0) {
            body = onWalk(path, body, scratch, frame, bodies, looks, variant);
        }
        if ((variant & Variant.MESHES) != 0) {
            body = MeshHit.find(path, body, scratch, frame, bodies, looks, meshes, variant);
        }
        return body;
    }

    /** The body that the ray ignores: the one that it leaves, unless it continues inside. */
    private static int ignored(float[] path, int variant) {
        int leaving = (int) path[Layout.LEAVING];
        if ((variant & Variant.MATERIALS) != 0) {
            leaving = path[Layout.INSIDE] > 0f ? Layout.NOTHING : leaving;
        }
        return leaving;
    }

    private static int amongFirst(
            float[] path, float limit, int count, float[] frame, float[] bodies, float[] looks, int variant) {
        int ignored = ignored(path, variant);
        float closest = limit;
        int hit = Layout.NOTHING;
        for (int body = 0; body < count; body++) {
            if (body != ignored) {
                Views.count(path, Views.TESTS, 1, variant);
                float distance = distance(path, body, frame, bodies, looks, variant);
                hit = distance < closest ? body : hit;
                closest = distance < closest ? distance : closest;
            }
        }
        path[Layout.DISTANCE] = closest;
        return hit;
    }

    private static float distance(float[] path, int body, float[] frame, float[] bodies, float[] looks, int variant) {
        int place = Layout.PLACE_STRIDE * body;
        float distance;
        if (body == Layout.PLANE) {
            distance = Intersection.plane(
                    bodies[place + 1],
                    bodies[place + Layout.PLACE_SIZE],
                    path[Layout.ORIGIN] - bodies[place],
                    path[Layout.ORIGIN + 1],
                    path[Layout.ORIGIN + 2] - bodies[place + 2],
                    path[Layout.DIRECTION],
                    path[Layout.DIRECTION + 1],
                    path[Layout.DIRECTION + 2]);
        } else {
            distance = sphere(path, place, body, frame, bodies, looks, variant);
        }
        return distance;
    }

    /**
     * Distance to a sphere given by center and radius in an array. Transmitting spheres are also hit from inside; a ray
     * against which a spot emits nothing does not hit it.
     */
    private static float sphere(
            float[] path, int at, int body, float[] frame, float[] bodies, float[] looks, int variant) {
        float x = bodies[at] - path[Layout.ORIGIN];
        float y = bodies[at + 1] - path[Layout.ORIGIN + 1];
        float z = bodies[at + 2] - path[Layout.ORIGIN + 2];
        float radius = bodies[at + Layout.PLACE_SIZE];
        float directionX = path[Layout.DIRECTION];
        float directionY = path[Layout.DIRECTION + 1];
        float directionZ = path[Layout.DIRECTION + 2];
        float distance = Intersection.sphere(x, y, z, radius, directionX, directionY, directionZ);
        if ((variant & Variant.MATERIALS) != 0) {
            int own = body == (int) path[Layout.LEAVING] ? 1 : 0;
            int transmits = Surface.isPassed(body, looks, variant);
            if ((transmits & (own | (distance == Intersection.MISS ? 1 : 0))) != 0) {
                distance = Intersection.sphereFromInside(x, y, z, radius, directionX, directionY, directionZ);
            }
        }
        if ((variant & Variant.LIGHTS) != 0) {
            if (distance < Intersection.MISS) {
                distance = SpotEmitter.isDark(path, body, looks) != 0 ? Intersection.MISS : distance;
            }
        }
        if ((variant & Variant.TWINS) != 0) {
            distance = Twin.distance(path, at, body, distance, frame, bodies, looks, variant);
        }
        return distance;
    }

    /**
     * Traverses the hierarchy, the nearer child first; skips nodes beyond the closest hit so far.
     *
     * @param first the closest hit so far
     */
    private static int onWalk(
            float[] path, int first, float[] scratch, float[] frame, float[] bodies, float[] looks, int variant) {
        float originX = path[Layout.ORIGIN];
        float originY = path[Layout.ORIGIN + 1];
        float originZ = path[Layout.ORIGIN + 2];
        float inverseX = NodeBox.inverse(path[Layout.DIRECTION]);
        float inverseY = NodeBox.inverse(path[Layout.DIRECTION + 1]);
        float inverseZ = NodeBox.inverse(path[Layout.DIRECTION + 2]);
        int node = (int) frame[Layout.ROOT];
        float growth = NodeBox.growth(bodies, node, originX, originY, originZ);
        float closest = path[Layout.DISTANCE];
        int hit = first;
        int waiting = 0;
        while (node != Layout.NO_NODE) {
            int link = (int) bodies[node + Layout.NODE_LINK];
            int spheres = (int) bodies[node + Layout.NODE_SPHERES];
            int next = Layout.NO_NODE;
            Views.count(path, Views.TESTS, spheres < 0 ? 2 : spheres, variant);
            if (spheres < 0) {
                float left =
                        NodeBox.entry(bodies, link, originX, originY, originZ, inverseX, inverseY, inverseZ, growth);
                float right = NodeBox.entry(
                        bodies,
                        link + Layout.NODE_STRIDE,
                        originX,
                        originY,
                        originZ,
                        inverseX,
                        inverseY,
                        inverseZ,
                        growth);
                int swapped = right < left ? Layout.NODE_STRIDE : 0;
                float near = right < left ? right : left;
                float far = right < left ? left : right;
                if (far <= closest) {
                    scratch[Layout.SCRATCH_STACK + 2 * waiting] = link + Layout.NODE_STRIDE - swapped;
                    scratch[Layout.SCRATCH_STACK + 2 * waiting + 1] = far;
                    waiting = waiting + 1;
                }
                next = near <= closest ? link + swapped : Layout.NO_NODE;
            }
            if (spheres > 0) {
                hit = inLeaf(path, hit, link, spheres, frame, bodies, looks, variant);
                closest = path[Layout.DISTANCE];
            }
            while (((next == Layout.NO_NODE ? 1 : 0) & (waiting > 0 ? 1 : 0)) != 0) {
                waiting = waiting - 1;
                float entry = scratch[Layout.SCRATCH_STACK + 2 * waiting + 1];
                next = entry <= closest ? (int) scratch[Layout.SCRATCH_STACK + 2 * waiting] : Layout.NO_NODE;
            }
            node = next;
        }
        return hit;
    }

    /** The closest hit so far, or a closer sphere of the leaf. */
    private static int inLeaf(
            float[] path, int first, int link, int spheres, float[] frame, float[] bodies, float[] looks, int variant) {
        int ignored = ignored(path, variant);
        float closest = path[Layout.DISTANCE];
        int hit = first;
        for (int sphere = 0; sphere < spheres; sphere++) {
            int at = link + Layout.SPHERE_STRIDE * sphere;
            int body = (int) bodies[at + Layout.SPHERE_BODY];
            float distance = sphere(path, at, body, frame, bodies, looks, variant);
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
