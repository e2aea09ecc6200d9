package dev.twister.kernel;

/**
 * Whether a ray or a cone may meet a node's box. Both err on one side only: rounding never drops a sphere that the plain
 * loop over all spheres would find.
 */
public final class NodeBox {
    /** What {@link #entry} is where the box is passed: beyond every distance, {@link Intersection#MISS} too. */
    public static final float PASSED = 3.3e38f;

    /**
     * How much a box is grown, as a part of its distance: {@link Intersection#sphere} rounds a centre's place across the
     * ray by some ten units of 2^-24 of its distance; this is three times as much. (The part that the box's own size
     * asks for is in the box.)
     */
    private static final float GROWTH = 2.0e-6f;

    /** What a shadow's cull allows beyond the sphere, as a part of the box's half sides: {@link SoftShadow}'s margin. */
    private static final float SIZE_MARGIN = SoftShadow.RELATIVE_MARGIN - 1f + 1.0e-4f;

    /** A direction's coordinate nearer to 0 is as good as 0, even over a million metres. */
    public static final float TINY = 1.0e-18f;

    private NodeBox() {}

    /** {@code 1 / coordinate} of a direction, and finite. */
    public static float inverse(float coordinate) {
        float away = coordinate < 0f ? -TINY : TINY;
        return 1f / (Math.abs(coordinate) > TINY ? coordinate : away);
    }

    /**
     * How many lengths of the direction lie before the box, less than 0 from inside; {@link #PASSED} where the ray passes
     * it.
     *
     * @param node where the node is in the hierarchy
     * @param inverseX {@link #inverse} of the direction's x
     */
    public static float entry(
            float[] hierarchy,
            int node,
            float originX,
            float originY,
            float originZ,
            float inverseX,
            float inverseY,
            float inverseZ) {
        float x = hierarchy[node + Layout.NODE_CENTER] - originX;
        float y = hierarchy[node + Layout.NODE_CENTER + 1] - originY;
        float z = hierarchy[node + Layout.NODE_CENTER + 2] - originZ;
        float growth = GROWTH * (Math.abs(x) + Math.abs(y) + Math.abs(z));
        float middleX = x * inverseX;
        float middleY = y * inverseY;
        float middleZ = z * inverseZ;
        float halfX = (hierarchy[node + Layout.NODE_HALF] + growth) * Math.abs(inverseX);
        float halfY = (hierarchy[node + Layout.NODE_HALF + 1] + growth) * Math.abs(inverseY);
        float halfZ = (hierarchy[node + Layout.NODE_HALF + 2] + growth) * Math.abs(inverseZ);
        float in = larger(larger(middleX - halfX, middleY - halfY), middleZ - halfZ);
        float out = smaller(smaller(middleX + halfX, middleY + halfY), middleZ + halfZ);
        int met = (in <= out ? 1 : 0) & (out >= 0f ? 1 : 0);
        return met != 0 ? in : PASSED;
    }

    /**
     * Metres along the axis from a point to the near side of the box, where a sphere in it may come between the point and
     * a disc; else {@link #PASSED}. The axis from the point to the disc's centre must meet the box, grown by as much as the
     * cone about the axis widens until the box's far side.
     *
     * @param axisX a unit vector from the point to the disc
     * @param inverseX {@link #inverse} of the axis's x
     * @param distance metres from the point to the disc
     * @param slope the tangent of the disc's half angle
     * @param slant its secant
     */
    public static float coneEntry(
            float[] hierarchy,
            int node,
            float pointX,
            float pointY,
            float pointZ,
            float axisX,
            float axisY,
            float axisZ,
            float inverseX,
            float inverseY,
            float inverseZ,
            float distance,
            float slope,
            float slant) {
        float x = hierarchy[node + Layout.NODE_CENTER] - pointX;
        float y = hierarchy[node + Layout.NODE_CENTER + 1] - pointY;
        float z = hierarchy[node + Layout.NODE_CENTER + 2] - pointZ;
        float sideX = hierarchy[node + Layout.NODE_HALF];
        float sideY = hierarchy[node + Layout.NODE_HALF + 1];
        float sideZ = hierarchy[node + Layout.NODE_HALF + 2];
        float margin = SoftShadow.ABSOLUTE_MARGIN
                        * (Math.abs(x) + Math.abs(y) + Math.abs(z) + distance + sideX + sideY + sideZ)
                + SIZE_MARGIN * slant * (sideX + sideY + sideZ);
        float along = x * axisX + y * axisY + z * axisZ;
        float alongHalf = sideX * Math.abs(axisX) + sideY * Math.abs(axisY) + sideZ * Math.abs(axisZ) + margin;
        float farSide = along + alongHalf;
        float growth = farSide * slope * SoftShadow.RELATIVE_MARGIN + margin;
        float middleX = x * inverseX;
        float middleY = y * inverseY;
        float middleZ = z * inverseZ;
        float halfX = (sideX + growth) * Math.abs(inverseX);
        float halfY = (sideY + growth) * Math.abs(inverseY);
        float halfZ = (sideZ + growth) * Math.abs(inverseZ);
        float in = larger(larger(middleX - halfX, middleY - halfY), middleZ - halfZ);
        float out = smaller(smaller(middleX + halfX, middleY + halfY), middleZ + halfZ);
        float nearSide = along - alongHalf;
        int met = (farSide > 0f ? 1 : 0)
                & (nearSide < distance * SoftShadow.RELATIVE_MARGIN ? 1 : 0)
                & (in <= out ? 1 : 0);
        return met != 0 ? nearSide : PASSED;
    }

    private static float larger(float a, float b) {
        return a > b ? a : b;
    }

    private static float smaller(float a, float b) {
        return a < b ? a : b;
    }
}
