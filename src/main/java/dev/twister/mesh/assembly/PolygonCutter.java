package dev.twister.mesh.assembly;

/**
 * Triangulates polygons, including concave ones, by ear clipping; a mutable object that is reused for many polygons.
 */
public final class PolygonCutter {
    public static final String EXHAUSTED = "the file's concave polygons are too large; triangulate them";

    /** Limit of several seconds of work. Ear clipping takes quadratic time in the number of corners, at worst cubic. */
    private static final long MAX_TESTS = 1_000_000_000L;

    private final IntList triangles = new IntList();
    private long tests;
    private double[] xs = new double[16];
    private double[] ys = new double[16];
    private int[] next = new int[16];
    private int[] previous = new int[16];

    /**
     * Triangulates a polygon into {@code count - 2} triangles with the same winding. For a polygon that crosses itself
     * or has no area, the result is arbitrary.
     *
     * @param positions positions of all vertices
     * @param corners the polygon's vertices
     * @param count number of corners, at least 3
     * @return three of the polygon's corners, in [0, count), per triangle; valid until the next call
     */
    public IntList cut(DoubleList positions, IntList corners, int count) {
        triangles.cut(0);
        if (count == 3) {
            add(0, 1, 2);
            return triangles;
        }
        project(positions, corners, count);
        if (isConvex(count)) {
            fan(0, count);
        } else {
            clipEars(count);
        }
        return triangles;
    }

    /** Whether the limit of work for all polygons was exceeded, so that the last result is arbitrary. */
    public boolean isExhausted() {
        return tests > MAX_TESTS;
    }

    private void add(int a, int b, int c) {
        triangles.add(a);
        triangles.add(b);
        triangles.add(c);
    }

    /** Projects the polygon onto the coordinate plane in which its area is largest, counterclockwise. */
    private void project(DoubleList positions, IntList corners, int count) {
        if (xs.length < count) {
            xs = new double[count];
            ys = new double[count];
            next = new int[count];
            previous = new int[count];
        }
        double[] normal = normal(positions, corners, count);
        int axis = 0;
        for (int other = 1; other < 3; other++) {
            axis = Math.abs(normal[other]) > Math.abs(normal[axis]) ? other : axis;
        }
        int right = (axis + 1) % 3;
        int up = (axis + 2) % 3;
        double side = normal[axis] < 0 ? -1 : 1;
        for (int i = 0; i < count; i++) {
            int at = 3 * corners.get(i);
            xs[i] = side * positions.get(at + right);
            ys[i] = positions.get(at + up);
            next[i] = i + 1 == count ? 0 : i + 1;
            previous[i] = i == 0 ? count - 1 : i - 1;
        }
    }

    /** The normal by Newell's method. */
    private static double[] normal(DoubleList positions, IntList corners, int count) {
        double[] normal = new double[3];
        int first = 3 * corners.get(0);
        for (int i = 0; i < count; i++) {
            int at = 3 * corners.get(i);
            int to = 3 * corners.get(i + 1 == count ? 0 : i + 1);
            for (int axis = 0; axis < 3; axis++) {
                int right = (axis + 1) % 3;
                int up = (axis + 2) % 3;
                double x = positions.get(at + right) - positions.get(first + right);
                double y = positions.get(at + up) - positions.get(first + up);
                double toX = positions.get(to + right) - positions.get(first + right);
                double toY = positions.get(to + up) - positions.get(first + up);
                normal[axis] += x * toY - toX * y;
            }
        }
        return normal;
    }

    private boolean isConvex(int count) {
        for (int i = 0; i < count; i++) {
            if (turn(previous[i], i, next[i]) <= 0) {
                return false;
            }
        }
        return true;
    }

    /** Positive if the path through three corners turns left. */
    private double turn(int a, int b, int c) {
        return (xs[b] - xs[a]) * (ys[c] - ys[a]) - (xs[c] - xs[a]) * (ys[b] - ys[a]);
    }

    /** Triangulates the {@code count} remaining corners as a fan around the first one. */
    private void fan(int first, int count) {
        int corner = next[first];
        for (int i = 2; i < count; i++) {
            add(first, corner, next[corner]);
            corner = next[corner];
        }
    }

    private void clipEars(int count) {
        int left = count;
        int corner = 0;
        int passed = 0;
        while (left > 3 && passed < left && !isExhausted()) {
            if (isEar(corner)) {
                add(previous[corner], corner, next[corner]);
                next[previous[corner]] = next[corner];
                previous[next[corner]] = previous[corner];
                left--;
                passed = 0;
                // Skips a corner: consecutive ears would form a fan of slivers.
                corner = next[next[corner]];
            } else {
                passed++;
                corner = next[corner];
            }
        }
        fan(corner, left);
    }

    private boolean isEar(int corner) {
        int before = previous[corner];
        int after = next[corner];
        if (turn(before, corner, after) <= 0) {
            return false;
        }
        for (int other = next[after]; other != before; other = next[other]) {
            tests++;
            if (isInside(other, before, corner, after)) {
                return false;
            }
        }
        return true;
    }

    /**
     * Whether a corner is inside a triangle or on its edge, but not at one of its corners, where holes may be joined.
     */
    private boolean isInside(int corner, int a, int b, int c) {
        return turn(a, b, corner) >= 0
                && turn(b, c, corner) >= 0
                && turn(c, a, corner) >= 0
                && !isSamePlace(corner, a)
                && !isSamePlace(corner, b)
                && !isSamePlace(corner, c);
    }

    private boolean isSamePlace(int corner, int other) {
        return xs[corner] == xs[other] && ys[corner] == ys[other];
    }
}
