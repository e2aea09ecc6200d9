package dev.twister.engine.vector;

import dev.twister.engine.vector.made.PathColumns;
import dev.twister.kernel.PathTracer;

/**
 * The paths in progress, in slots that begin with those whose hits packets find, then has those that lanes follow
 * alone. A slot is a lane of {@link PathColumns}.
 */
final class PathSlots {
    /** Kinds of slots, in their order. */
    private static final int TOGETHER = 0;

    private static final int TO_EMITTER = 1;
    private static final int APART = 2;
    private static final int ENDED = 3;

    final PathColumns columns;
    final int[] pixel;
    final int[] sample;

    /** Number of surfaces that the path has left. */
    final int[] bounce;

    /** What the next ray is: {@link PathTracer#TO_SURFACE} and the like. */
    final int[] ray;

    /** The body that the ray has met. */
    final int[] hit;

    /** What the ray after it is. */
    final int[] next;

    private final int[] kind;

    /** Slots in use, and those of them whose hits packets find. */
    int count;

    int together;

    /** Slots for a number of paths. */
    PathSlots(int paths) {
        columns = new PathColumns(paths);
        pixel = new int[paths];
        sample = new int[paths];
        bounce = new int[paths];
        ray = new int[paths];
        hit = new int[paths];
        next = new int[paths];
        kind = new int[paths];
    }

    void clear() {
        count = 0;
        together = 0;
    }

    /** Adds the first sample of a pixel, which is to be started. */
    void add(int newPixel, boolean isTogether) {
        pixel[count] = newPixel;
        columns.clear(count);
        restart(count, 0, isTogether);
        count++;
        together += isTogether ? 1 : 0;
    }

    /** Replaces a path by its pixel's next sample. */
    void restart(int slot, int newSample, boolean isTogether) {
        sample[slot] = newSample;
        bounce[slot] = 0;
        ray[slot] = PathTracer.NO_RAY;
        kind[slot] = isTogether ? TOGETHER : APART;
    }

    /** The path goes on by another ray. */
    void goOn(int slot, int nextRay, boolean isApart) {
        ray[slot] = nextRay;
        if (isApart || kind[slot] == APART) {
            kind[slot] = APART;
        } else {
            kind[slot] = nextRay == PathTracer.TO_EMITTER ? TO_EMITTER : TOGETHER;
        }
    }

    void end(int slot) {
        kind[slot] = ENDED;
    }

    /** Puts slots in their order, and frees those that have ended. */
    void sort() {
        int emitters = part(TOGETHER, 0);
        together = part(TO_EMITTER, emitters);
        count = part(APART, together);
    }

    /** Moves slots of a kind to the front of those from a place on; the end of that kind. */
    private int part(int wanted, int from) {
        int low = from;
        int high = count;
        while (low < high) {
            if (kind[low] == wanted) {
                low++;
            } else if (kind[high - 1] != wanted) {
                high--;
            } else {
                swap(low, high - 1);
            }
        }
        return low;
    }

    private void swap(int a, int b) {
        columns.swap(a, b);
        swap(pixel, a, b);
        swap(sample, a, b);
        swap(bounce, a, b);
        swap(ray, a, b);
        swap(kind, a, b);
    }

    private static void swap(int[] values, int a, int b) {
        int value = values[a];
        values[a] = values[b];
        values[b] = value;
    }
}
