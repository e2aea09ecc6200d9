package dev.twister.engine;

import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.stream.Collectors;

/**
 * Those of several engines that render frames of one kind together: the fastest ones, as many as give the shortest
 * frames. All are tried, then the slowest is left out, until the fastest renders alone. Trials are repeated where
 * frames become much longer or shorter, and from time to time, as compilers make engines faster.
 */
final class BandTeam {
    /** Frames of a trial that do not count: speeds are not known yet, and devices compile for their bands. */
    private static final int SETTLING = 2;

    private static final int MEASURED = 3;

    /** Factor by which frames must be shorter with another engine: beyond the clock's noise. */
    private static final double SHORTER = 0.97;

    /** Factor of a frame's time from which on the frames are others than those that were tried. */
    private static final double CHANGED = 4;

    /** Frames in a row, as other work on the machine makes single ones longer. */
    private static final int CHANGED_FRAMES = 5;

    /** Frames before the second trial, and by what this number grows with each. */
    private static final int FIRST_FRAMES = 100;

    private static final int MORE_FRAMES = 10;

    private final long[] shortestNanos;
    private List<BandWorker> order;
    private int size;
    private int frames;
    private boolean chosen;
    private int changed;
    private long framesToNext = FIRST_FRAMES;

    BandTeam(List<BandWorker> workers) {
        order = workers;
        shortestNanos = new long[workers.size()];
        restart();
    }

    /** Who renders the next frame. */
    List<BandWorker> taken() {
        return order.subList(0, size);
    }

    /** The engines' devices, for display; once that is known, without those that make frames longer. */
    String device() {
        return !chosen || size == order.size()
                ? names(order)
                : names(taken()) + "; faster without " + names(order.subList(size, order.size()));
    }

    private static String names(List<BandWorker> workers) {
        return workers.stream().map(worker -> worker.engine().device()).collect(Collectors.joining(" + "));
    }

    /** Tells how long a frame of those that were taken took. */
    void took(long nanos) {
        frames++;
        if (chosen) {
            double ratio = (double) nanos / shortestNanos[size - 1];
            changed = ratio > CHANGED || ratio < 1 / CHANGED ? changed + 1 : 0;
            if (changed == CHANGED_FRAMES) {
                restart();
            } else if (frames == framesToNext) {
                framesToNext *= MORE_FRAMES;
                restart();
            }
            return;
        }
        if (frames > SETTLING) {
            shortestNanos[size - 1] = Math.min(nanos, shortestNanos[size - 1]);
        }
        if (frames == SETTLING + MEASURED) {
            tryFewer();
        }
    }

    private void restart() {
        Arrays.fill(shortestNanos, Long.MAX_VALUE);
        size = order.size();
        frames = 0;
        changed = 0;
        // One engine has no choice.
        chosen = size == 1;
    }

    private void tryFewer() {
        if (size == order.size()) {
            order = order.stream()
                    .sorted(Comparator.comparingDouble(BandWorker::rowsASecond).reversed())
                    .toList();
        }
        frames = 0;
        size--;
        if (size == 0) {
            size = best();
            chosen = true;
        }
    }

    private int best() {
        int best = 1;
        for (int more = 2; more <= order.size(); more++) {
            if (shortestNanos[more - 1] < SHORTER * shortestNanos[best - 1]) {
                best = more;
            }
        }
        return best;
    }
}
