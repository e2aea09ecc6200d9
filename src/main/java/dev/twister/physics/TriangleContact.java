package dev.twister.physics;

/** Contact of a body with a triangle; for use by one thread. */
final class TriangleContact {
    /** For unit vectors: a neighbor that rises by less than this counts as coplanar. */
    private static final double ROUNDING = 1e-9;

    private final double[] corners;
    private final int at;
    private final double normalX;
    private final double normalY;
    private final double normalZ;

    /** Unit vector from the triangle's nearest point to the body's center, and the distance between both. */
    double x;

    double y;
    double z;
    double distance;

    /** Barycentric weights of the nearest point; 0 if it is on the edge opposite the corner. */
    private double first;

    private double second;
    private double third;

    /** Vector from the nearest point to the body's center. */
    private double awayX;

    private double awayY;
    private double awayZ;

    TriangleContact(double[] corners, int triangle) {
        this.corners = corners;
        at = 9 * triangle;
        double abX = edge(3);
        double abY = edge(4);
        double abZ = edge(5);
        double acX = edge(6);
        double acY = edge(7);
        double acZ = edge(8);
        double crossX = abY * acZ - abZ * acY;
        double crossY = abZ * acX - abX * acZ;
        double crossZ = abX * acY - abY * acX;
        double inverse = 1 / Math.sqrt(crossX * crossX + crossY * crossY + crossZ * crossZ);
        normalX = crossX * inverse;
        normalY = crossY * inverse;
        normalZ = crossZ * inverse;
    }

    /** Whether the triangle whose corners start at {@code at} has an area; flattening placements may remove it. */
    static boolean hasArea(double[] corners, int at) {
        double abX = corners[at + 3] - corners[at];
        double abY = corners[at + 4] - corners[at + 1];
        double abZ = corners[at + 5] - corners[at + 2];
        double acX = corners[at + 6] - corners[at];
        double acY = corners[at + 7] - corners[at + 1];
        double acZ = corners[at + 8] - corners[at + 2];
        double crossX = abY * acZ - abZ * acY;
        double crossY = abZ * acX - abX * acZ;
        double crossZ = abX * acY - abY * acX;
        return crossX * crossX + crossY * crossY + crossZ * crossZ >= Double.MIN_NORMAL;
    }

    private double edge(int number) {
        return corners[at + number] - corners[at + number % 3];
    }

    /**
     * Signed distance of a point from the triangle's plane, in meters; positive where the corners appear
     * counterclockwise.
     */
    double height(double px, double py, double pz) {
        return (px - corners[at]) * normalX + (py - corners[at + 1]) * normalY + (pz - corners[at + 2]) * normalZ;
    }

    /** Distance of the body's center from the triangle, in meters. */
    double away() {
        return Math.sqrt(awayX * awayX + awayY * awayY + awayZ * awayZ);
    }

    /** Whether the nearest point is inside the triangle, on no edge. */
    boolean isOver() {
        return first > 0 && second > 0 && third > 0;
    }

    /** Whether the nearest point is on the edge from that corner to the next one. */
    boolean isOn(int border) {
        return border == 0 ? third == 0 : border == 1 ? first == 0 : second == 0;
    }

    /**
     * Finds the point nearest to a body's center (Ericson, "Real-Time Collision Detection", 2005, 5.1.5), and the
     * direction in which the triangle pushes the body. Over the triangle, and if the move leads through it, that is the
     * normal on the body's side; then the distance is negative beyond the plane.
     *
     * @param side the side that the body belongs to: 0 where the corners appear counterclockwise, else 1
     * @param moveX with moveY and moveZ: the body's next move
     */
    void meet(double px, double py, double pz, int side, double moveX, double moveY, double moveZ) {
        double sign = side == 0 ? 1 : -1;
        double height = sign * height(px, py, pz);
        nearest(px, py, pz);
        boolean flat = isOver();
        if (!flat && height >= 0) {
            double fall = -sign * (moveX * normalX + moveY * normalY + moveZ * normalZ);
            if (fall > height) {
                double time = height / fall;
                double keptX = awayX;
                double keptY = awayY;
                double keptZ = awayZ;
                double keptFirst = first;
                double keptSecond = second;
                double keptThird = third;
                nearest(px + time * moveX, py + time * moveY, pz + time * moveZ);
                flat = isOver();
                if (!flat) {
                    awayX = keptX;
                    awayY = keptY;
                    awayZ = keptZ;
                    first = keptFirst;
                    second = keptSecond;
                    third = keptThird;
                }
            }
        }
        double length = away();
        if (flat || length == 0) {
            x = sign * normalX;
            y = sign * normalY;
            z = sign * normalZ;
            distance = height;
        } else {
            x = awayX / length;
            y = awayY / length;
            z = awayZ / length;
            distance = length;
        }
    }

    /**
     * The displacement of the nearest point along an axis.
     *
     * @param drifts those of all corners; empty if they rest
     */
    double drift(double[] drifts, int axis) {
        return drifts.length == 0
                ? 0
                : first * drifts[at + axis] + second * drifts[at + 3 + axis] + third * drifts[at + 6 + axis];
    }

    /** Whether the neighbor across the edge of the nearest point is nearer to the body's center. */
    boolean leansOver(double[] all, int triangle, int border, int other) {
        int from = 9 * triangle + 3 * border;
        int to = 9 * triangle + 3 * ((border + 1) % 3);
        double alongX = all[to] - all[from];
        double alongY = all[to + 1] - all[from + 1];
        double alongZ = all[to + 2] - all[from + 2];
        int opposite = 9 * other + 3 * oppositeCorner(all, from, to, other);
        double intoX = all[opposite] - all[from];
        double intoY = all[opposite + 1] - all[from + 1];
        double intoZ = all[opposite + 2] - all[from + 2];
        double share = (intoX * alongX + intoY * alongY + intoZ * alongZ)
                / (alongX * alongX + alongY * alongY + alongZ * alongZ);
        intoX -= share * alongX;
        intoY -= share * alongY;
        intoZ -= share * alongZ;
        double dot = awayX * intoX + awayY * intoY + awayZ * intoZ;
        double into = Math.sqrt(intoX * intoX + intoY * intoY + intoZ * intoZ);
        return dot > ROUNDING * into * away();
    }

    private static int oppositeCorner(double[] all, int from, int to, int other) {
        int opposite = 0;
        for (int corner = 0; corner < 3; corner++) {
            int place = 9 * other + 3 * corner;
            opposite = isSame(all, place, from) || isSame(all, place, to) ? opposite : corner;
        }
        return opposite;
    }

    private static boolean isSame(double[] all, int one, int two) {
        return all[one] == all[two] && all[one + 1] == all[two + 1] && all[one + 2] == all[two + 2];
    }

    private void nearest(double px, double py, double pz) {
        double abX = edge(3);
        double abY = edge(4);
        double abZ = edge(5);
        double acX = edge(6);
        double acY = edge(7);
        double acZ = edge(8);
        double apX = px - corners[at];
        double apY = py - corners[at + 1];
        double apZ = pz - corners[at + 2];
        double ab = abX * abX + abY * abY + abZ * abZ;
        double ac = acX * acX + acY * acY + acZ * acZ;
        double across = abX * acX + abY * acY + abZ * acZ;
        double d1 = abX * apX + abY * apY + abZ * apZ;
        double d2 = acX * apX + acY * apY + acZ * apZ;
        double d3 = d1 - ab;
        double d4 = d2 - across;
        double d5 = d1 - across;
        double d6 = d2 - ac;
        double ofC = d1 * d4 - d3 * d2;
        double ofB = d5 * d2 - d1 * d6;
        double ofA = d3 * d6 - d5 * d4;
        if (d1 <= 0 && d2 <= 0) {
            shares(0, 0);
        } else if (d3 >= 0 && d4 <= d3) {
            shares(1, 0);
        } else if (d6 >= 0 && d5 <= d6) {
            shares(0, 1);
        } else if (ofC <= 0 && d1 >= 0 && d3 <= 0) {
            shares(d1 / (d1 - d3), 0);
        } else if (ofB <= 0 && d2 >= 0 && d6 <= 0) {
            shares(0, d2 / (d2 - d6));
        } else if (ofA <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0) {
            double share = (d4 - d3) / ((d4 - d3) + (d5 - d6));
            shares(1 - share, share);
            first = 0;
        } else {
            double all = 1 / (ofA + ofB + ofC);
            shares(ofB * all, ofC * all);
        }
        awayX = apX - second * abX - third * acX;
        awayY = apY - second * abY - third * acY;
        awayZ = apZ - second * abZ - third * acZ;
    }

    private void shares(double ofSecond, double ofThird) {
        first = 1 - ofSecond - ofThird;
        second = ofSecond;
        third = ofThird;
    }
}
