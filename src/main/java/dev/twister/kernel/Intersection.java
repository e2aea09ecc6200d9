package dev.twister.kernel;

/** Intersections of rays and bodies. Directions are unit vectors, so distances are in meters. */
public final class Intersection {
    /** Distance of a miss. */
    public static final float MISS = 3.0e38f;

    /**
     * Half extent of the plane's square relative to its side. It is slightly more than 0.5, so that no border is at a
     * round number, where rounding alone would decide.
     */
    public static final float PLANE_REACH = 0.5f + 0x1p-17f;

    private Intersection() {}

    /**
     * Distance to the near side of a sphere; {@link #MISS} if the ray misses it or the near side is not in front. The
     * discriminant is computed from the perpendicular distance to the center, which stays accurate for small, distant
     * spheres. Whether the origin is outside depends only on the origin, so it is the same for all directions from a
     * point on the surface.
     *
     * @param x with y and z: the center relative to the ray's origin
     */
    public static float sphere(
            float x, float y, float z, float radius, float directionX, float directionY, float directionZ) {
        float along = x * directionX + y * directionY + z * directionZ;
        float acrossX = x - along * directionX;
        float acrossY = y - along * directionY;
        float acrossZ = z - along * directionZ;
        float halfChordSquared = radius * radius - (acrossX * acrossX + acrossY * acrossY + acrossZ * acrossZ);
        float distance = MISS;
        if (halfChordSquared >= 0f) {
            float near = along - (float) Math.sqrt(halfChordSquared);
            int inFront = (along > 0f ? 1 : 0) & (x * x + y * y + z * z > radius * radius ? 1 : 0);
            distance = inFront != 0 ? Math.max(near, 0f) : MISS;
        }
        return distance;
    }

    /**
     * Distance to the far side of a sphere, for rays from inside; {@link #MISS} if the ray misses it or the far side is
     * not in front. The center is relative to the ray's origin.
     */
    public static float sphereFromInside(
            float x, float y, float z, float radius, float directionX, float directionY, float directionZ) {
        float along = x * directionX + y * directionY + z * directionZ;
        float acrossX = x - along * directionX;
        float acrossY = y - along * directionY;
        float acrossZ = z - along * directionZ;
        float halfChordSquared = radius * radius - (acrossX * acrossX + acrossY * acrossY + acrossZ * acrossZ);
        float distance = MISS;
        if (halfChordSquared >= 0f) {
            float far = along + (float) Math.sqrt(halfChordSquared);
            distance = far > 0f ? far : MISS;
        }
        return distance;
    }

    /**
     * Distance to the plane's square, from above or below, including its border; {@link #MISS} elsewhere.
     *
     * @param height the plane's y, in meters
     * @param size the square's side, in meters
     * @param originX relative to the square's center
     * @param originZ relative to the square's center
     */
    public static float plane(
            float height,
            float size,
            float originX,
            float originY,
            float originZ,
            float directionX,
            float directionY,
            float directionZ) {
        float distance = MISS;
        if (directionY != 0f) {
            float along = (height - originY) / directionY;
            int inside =
                    isOnSquare(originX + along * directionX, originZ + along * directionZ, size) & (along > 0f ? 1 : 0);
            distance = inside != 0 ? along : MISS;
        }
        return distance;
    }

    /** 1 if a point of the plane, relative to the square's center, is on the square of the given side, else 0. */
    static int isOnSquare(float x, float z, float size) {
        float reach = PLANE_REACH * size;
        return (Math.abs(x) <= reach ? 1 : 0) & (Math.abs(z) <= reach ? 1 : 0);
    }
}
