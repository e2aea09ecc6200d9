package dev.twister.kernel;

/** What {@link ClosestHit} finds, exactly, by way of the hierarchy. */
public final class NearestHit {
    private NearestHit() {}

    /**
     * The closest body in front of the ray, the lower index on a tie; {@link Layout#NOTHING} where there is none. The
     * nearer child is walked first, and what begins beyond the closest sphere so far is not walked at all.
     *
     * @param ignored the body that the ray leaves, or {@link Layout#NOTHING}
     * @param root where in the hierarchy its root is, see {@link Layout#root}
     * @param scratch {@link Layout#SCRATCH_LENGTH} floats
     */
    public static int body(
            float originX,
            float originY,
            float originZ,
            float directionX,
            float directionY,
            float directionZ,
            int ignored,
            float[] bodyPositions,
            float[] bodySizes,
            float[] hierarchy,
            int root,
            float[] scratch) {
        float closest = Intersection.MISS;
        int hit = Layout.NOTHING;
        for (int body = 0; body < Layout.FIRST_SPHERE; body++) {
            if (body != ignored) {
                float distance = ClosestHit.distance(
                        body, originX, originY, originZ, directionX, directionY, directionZ, bodyPositions, bodySizes);
                hit = distance < closest ? body : hit;
                closest = distance < closest ? distance : closest;
            }
        }
        float inverseX = NodeBox.inverse(directionX);
        float inverseY = NodeBox.inverse(directionY);
        float inverseZ = NodeBox.inverse(directionZ);
        int node = root;
        int waiting = 0;
        while (node != Layout.NO_NODE) {
            int link = (int) hierarchy[node + Layout.NODE_LINK];
            int spheres = (int) hierarchy[node + Layout.NODE_SPHERES];
            int next = Layout.NO_NODE;
            if (spheres < 0) {
                float first = NodeBox.entry(hierarchy, link, originX, originY, originZ, inverseX, inverseY, inverseZ);
                float second = NodeBox.entry(
                        hierarchy, link + Layout.NODE_STRIDE, originX, originY, originZ, inverseX, inverseY, inverseZ);
                int swapped = second < first ? Layout.NODE_STRIDE : 0;
                float near = second < first ? second : first;
                float far = second < first ? first : second;
                if (far <= closest) {
                    scratch[Layout.SCRATCH_STACK + 2 * waiting] = link + Layout.NODE_STRIDE - swapped;
                    scratch[Layout.SCRATCH_STACK + 2 * waiting + 1] = far;
                    waiting = waiting + 1;
                }
                next = near <= closest ? link + swapped : Layout.NO_NODE;
            }
            for (int sphere = 0; sphere < spheres; sphere++) {
                int at = link + Layout.SPHERE_STRIDE * sphere;
                float distance = Intersection.sphere(
                        hierarchy[at] - originX,
                        hierarchy[at + 1] - originY,
                        hierarchy[at + 2] - originZ,
                        hierarchy[at + Layout.SPHERE_RADIUS],
                        directionX,
                        directionY,
                        directionZ);
                if (distance <= closest) {
                    int body = (int) hierarchy[at + Layout.SPHERE_BODY];
                    int closer = (distance < closest ? 1 : 0) | (body < hit ? 1 : 0);
                    int taken = closer & (body != ignored ? 1 : 0);
                    hit = taken != 0 ? body : hit;
                    closest = taken != 0 ? distance : closest;
                }
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
}
