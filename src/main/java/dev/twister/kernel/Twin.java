package dev.twister.kernel;

/**
 * Spheres in one place, with equal centers and radii: of those that a ray meets at once, the lowest number comes first.
 */
final class Twin {
    private Twin() {}

    /**
     * 1 if a sphere is in the place of another body, else 0.
     *
     * @param own any body, or {@link Layout#NOTHING}
     * @param at place of the sphere's center in {@code bodies}
     */
    static int is(int own, int at, int body, float[] frame, float[] bodies) {
        int other = (own >= Layout.FIRST_SPHERE ? 1 : 0) & (own < (int) frame[Layout.BODIES] ? 1 : 0);
        int place = Layout.PLACE_STRIDE * (other != 0 ? own : Layout.FIRST_SPHERE);
        return other
                & (body != own ? 1 : 0)
                & (bodies[at] == bodies[place] ? 1 : 0)
                & (bodies[at + 1] == bodies[place + 1] ? 1 : 0)
                & (bodies[at + 2] == bodies[place + 2] ? 1 : 0)
                & (bodies[at + Layout.PLACE_SIZE] == bodies[place + Layout.PLACE_SIZE] ? 1 : 0);
    }

    /**
     * Distance to a sphere. A ray that has crossed the surface of another one in its place meets it at once, if it has
     * the higher number; from inside only if it transmits. Other rays that leave there do not meet its near side, which
     * rounding alone would decide.
     *
     * @param found distance to the sphere wherever it is
     */
    static float distance(
            float[] path, int at, int body, float found, float[] frame, float[] bodies, float[] looks, int variant) {
        int leaving = (int) path[Layout.LEAVING];
        float distance = found;
        if (is(leaving, at, body, frame, bodies) != 0) {
            int inside = path[Layout.INSIDE] > 0f ? 1 : 0;
            int crossed = (path[Layout.INSIDE] < 0f ? 1 : 0) | (path[Layout.INSIDE] > 1f ? 1 : 0);
            int transmits = Surface.isPassed(body, looks, variant);
            int touches = crossed & (body > leaving ? 1 : 0) & (inside | transmits);
            float far = Intersection.MISS;
            if ((inside & transmits) != 0) {
                far = Intersection.sphereFromInside(
                        bodies[at] - path[Layout.ORIGIN],
                        bodies[at + 1] - path[Layout.ORIGIN + 1],
                        bodies[at + 2] - path[Layout.ORIGIN + 2],
                        bodies[at + Layout.PLACE_SIZE],
                        path[Layout.DIRECTION],
                        path[Layout.DIRECTION + 1],
                        path[Layout.DIRECTION + 2]);
            }
            distance = touches != 0 ? Triangle.TOUCHING : far;
        }
        return distance;
    }
}
