package dev.twister.kernel;

/** Which body a ray meets first. */
public final class ClosestHit {
    private ClosestHit() {}

    /**
     * The closest body in front of the ray, the lower index on a tie; {@link Layout#NOTHING} where there is none.
     *
     * @param ignored the body that the ray leaves, or {@link Layout#NOTHING}
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
            int bodies) {
        float closest = Intersection.MISS;
        int hit = Layout.NOTHING;
        for (int body = 0; body < bodies; body++) {
            if (body != ignored) {
                float distance = distance(
                        body, originX, originY, originZ, directionX, directionY, directionZ, bodyPositions, bodySizes);
                hit = distance < closest ? body : hit;
                closest = distance < closest ? distance : closest;
            }
        }
        return hit;
    }

    /** How far along the ray that body is, or {@link Intersection#MISS}. */
    public static float distance(
            int body,
            float originX,
            float originY,
            float originZ,
            float directionX,
            float directionY,
            float directionZ,
            float[] bodyPositions,
            float[] bodySizes) {
        float distance;
        if (body == Layout.PLANE) {
            distance = Intersection.plane(
                    bodyPositions[3 * body + 1],
                    bodySizes[body],
                    originX,
                    originY,
                    originZ,
                    directionX,
                    directionY,
                    directionZ);
        } else {
            distance = Intersection.sphere(
                    bodyPositions[3 * body] - originX,
                    bodyPositions[3 * body + 1] - originY,
                    bodyPositions[3 * body + 2] - originZ,
                    bodySizes[body],
                    directionX,
                    directionY,
                    directionZ);
        }
        return distance;
    }
}
