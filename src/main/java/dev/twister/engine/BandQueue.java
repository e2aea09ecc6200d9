package dev.twister.engine;

import java.util.Optional;

/** The rows of a frame that no engine has taken yet. Engines take bands from both ends, from several threads. */
final class BandQueue {
    private final int rows;
    private int first;
    private int end;
    private boolean stopped;

    /**
     * A band of rows.
     *
     * @param first its first row in the frame
     * @param rows at least 1
     */
    record Band(int first, int rows) {}

    BandQueue(int rows) {
        this.rows = rows;
        end = rows;
    }

    /** Number of rows of the frame. */
    int rows() {
        return rows;
    }

    /** Takes up to that many rows from the top; empty if none are left. */
    synchronized Optional<Band> takeFromTop(int most) {
        int taken = Math.min(most, left());
        first += taken;
        return band(first - taken, taken);
    }

    /**
     * Takes a share of the rows that are left from the bottom; empty if none are left. Bands get smaller towards the
     * end, so that all engines end together.
     *
     * @param share from 0 to 1
     * @param least rows, unless fewer are left
     */
    synchronized Optional<Band> takeFromBottom(double share, int least) {
        int taken = Math.min(Math.max(least, (int) (share * left())), left());
        end -= taken;
        return band(end, taken);
    }

    /** Leaves nothing to take. */
    synchronized void stop() {
        stopped = true;
    }

    private int left() {
        return stopped ? 0 : end - first;
    }

    private static Optional<Band> band(int first, int rows) {
        return rows > 0 ? Optional.of(new Band(first, rows)) : Optional.empty();
    }
}
