package dev.twister.kernel;

/**
 * Whether a ray or a cone may meet a node's box. Both err on one side only: rounding never drops a sphere that the
 * plain loop over all spheres would find.
 */
public final class NodeBox {
    /** What {@link #entry} is where the box is passed: beyond every distance, {@link Intersection#MISS} too. */
    public static final float PASSED = 3.3e38f;

    /**
     * How much a box is grown, as a part of its distance: {@link Intersection#sphere} rounds a center's place across
     * the ray by some ten units of 2^-24 of its distance; this is three times as much. (The part that the box's own
     * size asks for is in the box.)
     */
    public static final float GROWTH = 2.0e-6f;

    /** What a shadow's cull allows beyond the sphere, as a part of the box's half sides: {@link Shadow}'s margin. */
    private static final float SIZE_MARGIN = Shadow.RELATIVE_MARGIN - 1f + 1.0e-4f;

    /** A direction's coordinate nearer to 0 is as good as 0, even over a million meters. */
    public static final float TINY = 1.0e-18f;

    private NodeBox() {}

    /** {@code 1 / coordinate} of a direction, and finite. */
    public static float inverse(float coordinate) {
        float away = coordinate < 0f ? -TINY : TINY;
        return 1f / (Math.abs(coordinate) > TINY ? coordinate : away);
    }

    /**
     * How many lengths of the direction lie before the box, less than 0 from inside; {@link #PASSED} where the ray
     * passes it.
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
     * Meters along the axis from a point to the near side of the box, where a sphere in it may come between the point
     * and a disc; else {@link #PASSED}. The axis from the point to the disc's center must meet the box, grown by as
     * much as the cone about the axis widens until the box's far side.
     *
     * @param path with {@link Layout#POINT}, {@link Layout#TO_LIGHT}, and the disc's distance, tangent and secant
     * @param inverseX {@link #inverse} of the axis's x
     */
    static float coneEntry(float[] path, float[] hierarchy, int node, float inverseX, float inverseY, float inverseZ) {
        float axisX = path[Layout.TO_LIGHT];
        float axisY = path[Layout.TO_LIGHT + 1];
        float axisZ = path[Layout.TO_LIGHT + 2];
        float distance = path[Layout.LIGHT_DISTANCE];
        float tangent = path[Layout.DISC_TANGENT];
        float secant = path[Layout.DISC_SECANT];
        float x = hierarchy[node + Layout.NODE_CENTER] - path[Layout.POINT];
        float y = hierarchy[node + Layout.NODE_CENTER + 1] - path[Layout.POINT + 1];
        float z = hierarchy[node + Layout.NODE_CENTER + 2] - path[Layout.POINT + 2];
        float sideX = hierarchy[node + Layout.NODE_HALF];
        float sideY = hierarchy[node + Layout.NODE_HALF + 1];
        float sideZ = hierarchy[node + Layout.NODE_HALF + 2];
        float margin =
                Shadow.ABSOLUTE_MARGIN * (Math.abs(x) + Math.abs(y) + Math.abs(z) + distance + sideX + sideY + sideZ)
                        + SIZE_MARGIN * secant * (sideX + sideY + sideZ);
        float along = x * axisX + y * axisY + z * axisZ;
        float alongHalf = sideX * Math.abs(axisX) + sideY * Math.abs(axisY) + sideZ * Math.abs(axisZ) + margin;
        float farSide = along + alongHalf;
        float growth = farSide * tangent * Shadow.RELATIVE_MARGIN + margin;
        float middleX = x * inverseX;
        float middleY = y * inverseY;
        float middleZ = z * inverseZ;
        float halfX = (sideX + growth) * Math.abs(inverseX);
        float halfY = (sideY + growth) * Math.abs(inverseY);
        float halfZ = (sideZ + growth) * Math.abs(inverseZ);
        float in = larger(larger(middleX - halfX, middleY - halfY), middleZ - halfZ);
        float out = smaller(smaller(middleX + halfX, middleY + halfY), middleZ + halfZ);
        float nearSide = along - alongHalf;
        int met = (farSide > 0f ? 1 : 0) & (nearSide < distance * Shadow.RELATIVE_MARGIN ? 1 : 0) & (in <= out ? 1 : 0);
        return met != 0 ? nearSide : PASSED;
    }

    private static float larger(float a, float b) {
        return a > b ? a : b;
    }

    private static float smaller(float a, float b) {
        return a < b ? a : b;
    }
}
