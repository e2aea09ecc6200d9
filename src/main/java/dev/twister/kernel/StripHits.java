package dev.twister.kernel;

/** The closest hits of a strip's rays, see {@link ClosestHit}. */
final class StripHits {
    private StripHits() {}

    /** By a loop over all bodies. */
    static void ofAllBodies(
            int pixels, float[] bodyPositions, float[] bodySizes, int bodies, float[] lanes, int[] marks) {
        for (int lane = 0; lane < pixels; lane++) {
            int finished = marks[Strip.LEAVING + lane] == Strip.FINISHED ? 1 : 0;
            // No distance is below 0, so that lanes whose path has ended meet nothing.
            lanes[Strip.DISTANCE + lane] = finished != 0 ? -1f : Intersection.MISS;
            marks[Strip.HIT + lane] = finished != 0 ? Strip.FINISHED : Layout.NOTHING;
        }
        sphere(Layout.LIGHT, pixels, bodyPositions, bodySizes, lanes, marks);
        plane(pixels, bodyPositions, bodySizes, lanes, marks);
        for (int body = Layout.FIRST_SPHERE; body < bodies; body++) {
            sphere(body, pixels, bodyPositions, bodySizes, lanes, marks);
        }
    }

    private static void sphere(
            int body, int pixels, float[] bodyPositions, float[] bodySizes, float[] lanes, int[] marks) {
        float centerX = bodyPositions[3 * body];
        float centerY = bodyPositions[3 * body + 1];
        float centerZ = bodyPositions[3 * body + 2];
        float radius = bodySizes[body];
        for (int lane = 0; lane < pixels; lane++) {
            float distance = Intersection.sphere(
                    centerX - lanes[Strip.ORIGIN_X + lane],
                    centerY - lanes[Strip.ORIGIN_Y + lane],
                    centerZ - lanes[Strip.ORIGIN_Z + lane],
                    radius,
                    lanes[Strip.DIRECTION_X + lane],
                    lanes[Strip.DIRECTION_Y + lane],
                    lanes[Strip.DIRECTION_Z + lane]);
            take(body, distance, lane, lanes, marks);
        }
    }

    private static void plane(int pixels, float[] bodyPositions, float[] bodySizes, float[] lanes, int[] marks) {
        float height = bodyPositions[3 * Layout.PLANE + 1];
        float size = bodySizes[Layout.PLANE];
        for (int lane = 0; lane < pixels; lane++) {
            float distance = Intersection.plane(
                    height,
                    size,
                    lanes[Strip.ORIGIN_X + lane],
                    lanes[Strip.ORIGIN_Y + lane],
                    lanes[Strip.ORIGIN_Z + lane],
                    lanes[Strip.DIRECTION_X + lane],
                    lanes[Strip.DIRECTION_Y + lane],
                    lanes[Strip.DIRECTION_Z + lane]);
            take(Layout.PLANE, distance, lane, lanes, marks);
        }
    }

    /** Bodies come in the order of their indices, so that the lower one is kept on a tie. */
    private static void take(int body, float distance, int lane, float[] lanes, int[] marks) {
        float closest = lanes[Strip.DISTANCE + lane];
        int hit = marks[Strip.HIT + lane];
        int taken = (distance < closest ? 1 : 0) & (marks[Strip.LEAVING + lane] != body ? 1 : 0);
        marks[Strip.HIT + lane] = taken != 0 ? body : hit;
        lanes[Strip.DISTANCE + lane] = taken != 0 ? distance : closest;
    }

    /** By the walk through the hierarchy, lane by lane. */
    static void ofHierarchy(
            int pixels,
            float[] bodyPositions,
            float[] bodySizes,
            float[] hierarchy,
            int root,
            float[] lanes,
            int[] marks,
            float[] scratch) {
        for (int lane = 0; lane < pixels; lane++) {
            int hit = Strip.FINISHED;
            float distance = Intersection.MISS;
            if (marks[Strip.LEAVING + lane] != Strip.FINISHED) {
                float originX = lanes[Strip.ORIGIN_X + lane];
                float originY = lanes[Strip.ORIGIN_Y + lane];
                float originZ = lanes[Strip.ORIGIN_Z + lane];
                float directionX = lanes[Strip.DIRECTION_X + lane];
                float directionY = lanes[Strip.DIRECTION_Y + lane];
                float directionZ = lanes[Strip.DIRECTION_Z + lane];
                hit = NearestHit.body(
                        originX,
                        originY,
                        originZ,
                        directionX,
                        directionY,
                        directionZ,
                        marks[Strip.LEAVING + lane],
                        bodyPositions,
                        bodySizes,
                        hierarchy,
                        root,
                        scratch);
                if (hit >= 0) {
                    distance = ClosestHit.distance(
                            hit,
                            originX,
                            originY,
                            originZ,
                            directionX,
                            directionY,
                            directionZ,
                            bodyPositions,
                            bodySizes);
                }
            }
            marks[Strip.HIT + lane] = hit;
            lanes[Strip.DISTANCE + lane] = distance;
        }
    }
}
