package dev.twister.sky.webp;

import java.util.Arrays;

/** Predicts blocks from their neighbors (RFC 6386, section 12). */
final class Vp8Prediction {
    static final int MEAN = 0;
    static final int TRUE_MOTION = 1;
    static final int VERTICAL = 2;
    static final int HORIZONTAL = 3;
    private static final int RIGHT_DOWN = 4;
    private static final int VERTICAL_RIGHT = 5;
    private static final int LEFT_DOWN = 6;
    private static final int VERTICAL_LEFT = 7;
    private static final int HORIZONTAL_DOWN = 8;

    /** In the edge: below it the left neighbors, upward; above it the neighbors above. */
    private static final int CORNER = 4;

    private Vp8Prediction() {}

    /** Predicts a whole macroblock's luma or chroma, of a side of 16 or 8. */
    static void macroblock(Vp8Plane plane, int column, int row, int side, int mode) {
        int start = plane.at(column * side, row * side);
        if (mode == MEAN) {
            fill(plane, start, side, mean(plane, start, side, row > 0, column > 0));
        } else {
            for (int y = 0; y < side; y++) {
                copy(plane, start + y * plane.stride(), start - plane.stride(), side, mode);
            }
        }
    }

    private static void copy(Vp8Plane plane, int to, int above, int side, int mode) {
        int left = plane.value(to - 1);
        int corner = plane.value(above - 1);
        for (int x = 0; x < side; x++) {
            plane.set(
                    to + x,
                    switch (mode) {
                        case VERTICAL -> plane.value(above + x);
                        case HORIZONTAL -> left;
                        default -> left + plane.value(above + x) - corner;
                    });
        }
    }

    private static int mean(Vp8Plane plane, int start, int side, boolean above, boolean left) {
        int sum = 0;
        for (int i = 0; i < side; i++) {
            sum += above ? plane.value(start - plane.stride() + i) : 0;
            sum += left ? plane.value(start - 1 + i * plane.stride()) : 0;
        }
        int count = side * ((above ? 1 : 0) + (left ? 1 : 0));
        return count == 0 ? 128 : (sum + count / 2) / count;
    }

    private static void fill(Vp8Plane plane, int start, int side, int value) {
        for (int y = 0; y < side; y++) {
            int at = start + y * plane.stride();
            Arrays.fill(plane.values(), at, at + side, (byte) value);
        }
    }

    /**
     * Predicts a block of 4 x 4.
     *
     * @param right the four values above and to the right
     */
    static void block(Vp8Plane plane, int start, int mode, int[] right) {
        switch (mode) {
            case MEAN -> fill(plane, start, 4, mean(plane, start, 4, true, true));
            case TRUE_MOTION -> {
                for (int y = 0; y < 4; y++) {
                    copy(plane, start + y * plane.stride(), start - plane.stride(), 4, mode);
                }
            }
            default -> {
                int[] edge = edge(plane, start, right);
                for (int y = 0; y < 4; y++) {
                    for (int x = 0; x < 4; x++) {
                        plane.set(start + y * plane.stride() + x, directed(mode, x, y, edge));
                    }
                }
            }
        }
    }

    private static int[] edge(Vp8Plane plane, int start, int[] right) {
        int[] edge = new int[CORNER + 9];
        for (int i = 0; i < 4; i++) {
            edge[i] = plane.value(start - 1 + (3 - i) * plane.stride());
            edge[CORNER + 1 + i] = plane.value(start - plane.stride() + i);
            edge[CORNER + 5 + i] = right[i];
        }
        edge[CORNER] = plane.value(start - plane.stride() - 1);
        return edge;
    }

    private static int directed(int mode, int x, int y, int[] edge) {
        return switch (mode) {
            case VERTICAL -> three(edge, CORNER + 1 + x);
            case HORIZONTAL -> three(edge, CORNER - 1 - y);
            case RIGHT_DOWN -> three(edge, CORNER + x - y);
            case VERTICAL_RIGHT -> verticalRight(x, y, edge);
            case LEFT_DOWN -> three(edge, CORNER + 2 + x + y);
            case VERTICAL_LEFT -> verticalLeft(x, y, edge);
            case HORIZONTAL_DOWN -> horizontalDown(x, y, edge);
            default -> horizontalUp(x + 2 * y, edge);
        };
    }

    private static int verticalRight(int x, int y, int[] edge) {
        int place = 2 * x - y;
        if (place < 0) {
            return three(edge, CORNER + 1 + place);
        }
        int at = CORNER + x - (y >> 1);
        return (y & 1) == 0 ? two(edge, at) : three(edge, at);
    }

    private static int verticalLeft(int x, int y, int[] edge) {
        if (x == 3 && y >= 2) {
            return three(edge, CORNER + 4 + y);
        }
        int at = CORNER + 1 + x + (y >> 1);
        return (y & 1) == 0 ? two(edge, at) : three(edge, at + 1);
    }

    private static int horizontalDown(int x, int y, int[] edge) {
        int place = 2 * y - x;
        if (place < 0) {
            return three(edge, CORNER - 1 - place);
        }
        int at = CORNER - y + (x >> 1);
        return (x & 1) == 0 ? two(edge, at - 1) : three(edge, at);
    }

    private static int horizontalUp(int place, int[] edge) {
        int at = CORNER - 1 - (place >> 1);
        if (place > 5) {
            return edge[0];
        }
        return (place & 1) == 0 ? two(edge, at - 1) : three(edge, at - 1);
    }

    /** The mean of a value and its next. */
    private static int two(int[] edge, int at) {
        return (edge[at] + edge[at + 1] + 1) >> 1;
    }

    /** The mean of a value, twice, and its neighbors. */
    private static int three(int[] edge, int at) {
        int before = edge[Math.max(at - 1, 0)];
        int after = edge[Math.min(at + 1, edge.length - 1)];
        return (before + 2 * edge[at] + after + 2) >> 2;
    }
}
