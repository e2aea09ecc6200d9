package dev.twister.kernel;

/** Where a ray meets a body; directions are unit vectors, so that distances are in meters. */
public final class Intersection {
    /** The distance of what is not hit. */
    public static final float MISS = 3.0e38f;

    /**
     * Of the plane's side, how far the square reaches from its middle: a little beyond the half, so that no border is
     * at a round number, where rounding alone decides.
     */
    public static final float PLANE_REACH = 0.5f + 0x1p-17f;

    private Intersection() {}

    /**
     * Distance to the near side of a sphere; {@link #MISS} where the ray passes it, or where the near side is not in
     * front. The discriminant comes from the ray's perpendicular distance to the center, which keeps its digits where
     * the sphere is small and far. Whether the origin is outside is asked of the origin alone: for one on the surface,
     * it is the same in all directions.
     *
     * @param x the center, seen from the ray's origin
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
     * Distance to the far side of a sphere, which is what a ray from inside meets; {@link #MISS} where the ray passes
     * it, or where the far side is not in front. The center is seen from the ray's origin.
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
     * Distance to the square ground, from above or below, its border inside; {@link #MISS} elsewhere.
     *
     * @param height the plane's, in meters
     * @param size the square's side, in meters
     * @param originX from the square's center
     * @param originZ from the square's center
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

    /** 1 where a point of the plane, seen from the square's center, lies on its square of that side, else 0. */
    static int isOnSquare(float x, float z, float size) {
        float reach = PLANE_REACH * size;
        return (Math.abs(x) <= reach ? 1 : 0) & (Math.abs(z) <= reach ? 1 : 0);
    }
}
