package dev.twister.sky.webp;

/** Smooths the edges of macroblocks and blocks (RFC 6386, section 15). */
final class Vp8LoopFilter {
    private Vp8LoopFilter() {}

    /** Filters luma alone, by the simple filter. */
    static void simple(Vp8Plane luma, int column, int row, int limit, boolean inner) {
        int start = luma.at(16 * column, 16 * row);
        for (int vertical = 0; vertical < 2; vertical++) {
            int across = vertical == 0 ? 1 : luma.stride();
            int along = vertical == 0 ? luma.stride() : 1;
            if ((vertical == 0 ? column : row) > 0) {
                simpleEdge(luma, start, across, along, 2 * (limit + 4) + 1);
            }
            for (int edge = 4; inner && edge < 16; edge += 4) {
                simpleEdge(luma, start + edge * across, across, along, 2 * limit + 1);
            }
        }
    }

    private static void simpleEdge(Vp8Plane plane, int start, int across, int along, int threshold) {
        for (int i = 0; i < 16; i++) {
            int at = start + i * along;
            if (isFlat(plane, at, across, threshold)) {
                two(plane, at, across);
            }
        }
    }

    /** Filters a plane by the normal filter. */
    static void normal(Vp8Plane plane, int column, int row, int side, Vp8Header.Strength strength, boolean inner) {
        int start = plane.at(side * column, side * row);
        int limit = strength.limit();
        for (int vertical = 0; vertical < 2; vertical++) {
            int across = vertical == 0 ? 1 : plane.stride();
            int along = vertical == 0 ? plane.stride() : 1;
            if ((vertical == 0 ? column : row) > 0) {
                for (int i = 0; i < side; i++) {
                    outer(plane, start + i * along, across, 2 * (limit + 4) + 1, strength);
                }
            }
            for (int edge = 4; inner && edge < side; edge += 4) {
                for (int i = 0; i < side; i++) {
                    inner(plane, start + edge * across + i * along, across, 2 * limit + 1, strength);
                }
            }
        }
    }

    private static void outer(Vp8Plane plane, int at, int step, int threshold, Vp8Header.Strength strength) {
        if (isSmooth(plane, at, step, threshold, strength.interior())) {
            if (isHighVariance(plane, at, step, strength.highVariance())) {
                two(plane, at, step);
            } else {
                six(plane, at, step);
            }
        }
    }

    private static void inner(Vp8Plane plane, int at, int step, int threshold, Vp8Header.Strength strength) {
        if (isSmooth(plane, at, step, threshold, strength.interior())) {
            if (isHighVariance(plane, at, step, strength.highVariance())) {
                two(plane, at, step);
            } else {
                four(plane, at, step);
            }
        }
    }

    private static int difference(Vp8Plane plane, int a, int b) {
        return Math.abs(plane.value(a) - plane.value(b));
    }

    private static boolean isFlat(Vp8Plane plane, int at, int step, int threshold) {
        return 4 * difference(plane, at - step, at) + difference(plane, at - 2 * step, at + step) <= threshold;
    }

    private static boolean isSmooth(Vp8Plane plane, int at, int step, int threshold, int interior) {
        boolean smooth = isFlat(plane, at, step, threshold);
        for (int i = 1; smooth && i <= 3; i++) {
            smooth = difference(plane, at - (i + 1) * step, at - i * step) <= interior
                    && difference(plane, at + (i - 1) * step, at + i * step) <= interior;
        }
        return smooth;
    }

    private static boolean isHighVariance(Vp8Plane plane, int at, int step, int threshold) {
        return difference(plane, at - 2 * step, at - step) > threshold || difference(plane, at + step, at) > threshold;
    }

    private static int signed(int value) {
        return Math.clamp(value, -128, 127);
    }

    private static void two(Vp8Plane plane, int at, int step) {
        int before = plane.value(at - step);
        int after = plane.value(at);
        int a = 3 * (after - before) + signed(plane.value(at - 2 * step) - plane.value(at + step));
        plane.set(at - step, before + eighth(a + 3));
        plane.set(at, after - eighth(a + 4));
    }

    private static void four(Vp8Plane plane, int at, int step) {
        int before = plane.value(at - step);
        int after = plane.value(at);
        int a = 3 * (after - before);
        int down = eighth(a + 4);
        int outside = (down + 1) >> 1;
        plane.set(at - 2 * step, plane.value(at - 2 * step) + outside);
        plane.set(at - step, before + eighth(a + 3));
        plane.set(at, after - down);
        plane.set(at + step, plane.value(at + step) - outside);
    }

    /** An eighth of a step, in [-16, 15]. */
    private static int eighth(int step) {
        return Math.clamp(step >> 3, -16, 15);
    }

    private static void six(Vp8Plane plane, int at, int step) {
        int a = signed(3 * (plane.value(at) - plane.value(at - step))
                + signed(plane.value(at - 2 * step) - plane.value(at + step)));
        for (int i = 1; i <= 3; i++) {
            int change = (9 * (4 - i) * a + 63) >> 7;
            plane.set(at - i * step, plane.value(at - i * step) + change);
            plane.set(at + (i - 1) * step, plane.value(at + (i - 1) * step) - change);
        }
    }
}
