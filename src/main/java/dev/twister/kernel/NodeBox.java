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

    /** Growth of boxes that cones are tested against, relative to that for rays. */
    private static final float CONE_GROWTH = Shadow.ABSOLUTE_MARGIN / GROWTH;

    /** Rounding of a unit vector's components. */
    private static final float LEAST_SPREAD = 1.0e-6f;

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
     * Half width, along one axis, of the directions from a point to a disc, per length along the axis to its center.
     *
     * @param a with b: the other two components of the unit vector to the disc's center
     * @param tangent of the disc's half angle
     */
    static float spread(float a, float b, float tangent) {
        return tangent * Shadow.RELATIVE_MARGIN * (float) Math.sqrt(a * a + b * b) + LEAST_SPREAD;
    }

    /** As {@link #growth}, for cones that end at a distance. */
    static float coneGrowth(float[] path, float[] hierarchy, int root) {
        float growth = growth(hierarchy, root, path[Layout.POINT], path[Layout.POINT + 1], path[Layout.POINT + 2]);
        return CONE_GROWTH * growth + Shadow.ABSOLUTE_MARGIN * path[Layout.LIGHT_DISTANCE];
    }

    /**
     * Distance along the axis at which the cone from a point to a disc enters a box; {@link #PASSED} if it misses the
     * box. The cone is replaced by the wider one of all directions whose components lie between a least and a most one.
     *
     * @param path with {@link Layout#POINT}
     * @param leastX {@link #inverse} of the least x, {@code axis - spread}; leastY and leastZ likewise
     * @param greatestX {@link #inverse} of the most x, {@code axis + spread}; greatestY and greatestZ likewise
     */
    static float coneEntry(
            float[] path,
            float[] hierarchy,
            int node,
            float leastX,
            float leastY,
            float leastZ,
            float greatestX,
            float greatestY,
            float greatestZ,
            float growth) {
        float x = hierarchy[node + Layout.NODE_CENTER] - path[Layout.POINT];
        float y = hierarchy[node + Layout.NODE_CENTER + 1] - path[Layout.POINT + 1];
        float z = hierarchy[node + Layout.NODE_CENTER + 2] - path[Layout.POINT + 2];
        float halfX = hierarchy[node + Layout.NODE_HALF] + growth;
        float halfY = hierarchy[node + Layout.NODE_HALF + 1] + growth;
        float halfZ = hierarchy[node + Layout.NODE_HALF + 2] + growth;
        float lowX = (x - halfX) * greatestX;
        float lowY = (y - halfY) * greatestY;
        float lowZ = (z - halfZ) * greatestZ;
        float highX = (x + halfX) * leastX;
        float highY = (y + halfY) * leastY;
        float highZ = (z + halfZ) * leastZ;
        float in = 0f;
        float out = PASSED;
        if (greatestX > 0f) {
            in = Math.max(in, lowX);
        } else {
            out = Math.min(out, lowX);
        }
        if (greatestY > 0f) {
            in = Math.max(in, lowY);
        } else {
            out = Math.min(out, lowY);
        }
        if (greatestZ > 0f) {
            in = Math.max(in, lowZ);
        } else {
            out = Math.min(out, lowZ);
        }
        if (leastX > 0f) {
            out = Math.min(out, highX);
        } else {
            in = Math.max(in, highX);
        }
        if (leastY > 0f) {
            out = Math.min(out, highY);
        } else {
            in = Math.max(in, highY);
        }
        if (leastZ > 0f) {
            out = Math.min(out, highZ);
        } else {
            in = Math.max(in, highZ);
        }
        return in <= out ? in : PASSED;
    }
}
