package dev.twister.kernel;

/**
 * Conservative tests of rays and cones against a node's box: rounding never drops a sphere that a loop over all spheres
 * would find.
 */
public final class NodeBox {
    /** {@link #entry} of a box that is missed: greater than any distance, including {@link Intersection#MISS}. */
    public static final float PASSED = 3.3e38f;

    /**
     * Growth of a box relative to its distance. {@link Intersection#sphere} rounds a center's position across the ray
     * by about 10 * 2^-24 of its distance; this is three times as much. (The growth relative to its size is stored in
     * the box.)
     */
    public static final float GROWTH = 2.0e-6f;

    /** Margin of a shadow's culling relative to the box's half sides: that of {@link Shadow}. */
    private static final float SIZE_MARGIN = Shadow.RELATIVE_MARGIN - 1f + 1.0e-4f;

    /** Components of a direction with a smaller absolute value are irrelevant even over a million meters. */
    public static final float TINY = 1.0e-18f;

    private NodeBox() {}

    /** {@code 1 / coordinate} of a direction, but always finite. */
    public static float inverse(float coordinate) {
        float away = coordinate < 0f ? -TINY : TINY;
        return 1f / (Math.abs(coordinate) > TINY ? coordinate : away);
    }

    /**
     * Growth of all boxes for rays from an origin: that of the root's farthest corner.
     *
     * @param root place of the root in the hierarchy
     */
    public static float growth(float[] hierarchy, int root, float originX, float originY, float originZ) {
        float x = Math.abs(hierarchy[root + Layout.NODE_CENTER] - originX) + hierarchy[root + Layout.NODE_HALF];
        float y = Math.abs(hierarchy[root + Layout.NODE_CENTER + 1] - originY) + hierarchy[root + Layout.NODE_HALF + 1];
        float z = Math.abs(hierarchy[root + Layout.NODE_CENTER + 2] - originZ) + hierarchy[root + Layout.NODE_HALF + 2];
        return GROWTH * (x + y + z);
    }

    /**
     * Distance to the box in lengths of the direction, negative from inside; {@link #PASSED} if the ray misses it.
     *
     * @param node place of the node in the hierarchy
     * @param inverseX {@link #inverse} of the direction's x; inverseY and inverseZ likewise
     * @param growth {@link #growth} of the hierarchy's boxes
     */
    public static float entry(
            float[] hierarchy,
            int node,
            float originX,
            float originY,
            float originZ,
            float inverseX,
            float inverseY,
            float inverseZ,
            float growth) {
        float middleX = (hierarchy[node + Layout.NODE_CENTER] - originX) * inverseX;
        float middleY = (hierarchy[node + Layout.NODE_CENTER + 1] - originY) * inverseY;
        float middleZ = (hierarchy[node + Layout.NODE_CENTER + 2] - originZ) * inverseZ;
        float halfX = (hierarchy[node + Layout.NODE_HALF] + growth) * Math.abs(inverseX);
        float halfY = (hierarchy[node + Layout.NODE_HALF + 1] + growth) * Math.abs(inverseY);
        float halfZ = (hierarchy[node + Layout.NODE_HALF + 2] + growth) * Math.abs(inverseZ);
        float in = Math.max(Math.max(middleX - halfX, middleY - halfY), middleZ - halfZ);
        float out = Math.min(Math.min(middleX + halfX, middleY + halfY), middleZ + halfZ);
        return Math.max(in, 0f) <= out ? in : PASSED;
    }

    /**
     * Distance in meters along the axis from a point to the near side of the box, if a sphere in it may lie between the
     * point and a disc; else {@link #PASSED}. The axis from the point to the disc's center must meet the box, which is
     * grown by the cone's radius at the box's far side.
     *
     * @param path with {@link Layout#POINT}, {@link Layout#TO_LIGHT}, and the disc's distance, tangent and secant
     * @param inverseX {@link #inverse} of the axis's x; inverseY and inverseZ likewise
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
        float in = Math.max(Math.max(middleX - halfX, middleY - halfY), middleZ - halfZ);
        float out = Math.min(Math.min(middleX + halfX, middleY + halfY), middleZ + halfZ);
        float nearSide = along - alongHalf;
        int met = (farSide > 0f ? 1 : 0) & (nearSide < distance * Shadow.RELATIVE_MARGIN ? 1 : 0) & (in <= out ? 1 : 0);
        return met != 0 ? nearSide : PASSED;
    }
}
