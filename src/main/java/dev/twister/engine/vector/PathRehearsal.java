package dev.twister.engine.vector;

import dev.twister.engine.ProcessorTime;
import dev.twister.engine.vector.frame.Drawing;
import dev.twister.engine.vector.lanes.Lanes;
import dev.twister.engine.vector.lanes.Tile;
import dev.twister.world.FrameInput;
import java.util.Optional;

/**
 * Follows paths in made lanes while packets and the kernel draw, until the JIT compiler has compiled them: before that
 * they are hundreds of times slower. Both give the same picture, so that it may change at any tile. One thread
 * rehearses, between its tiles, on the paths of the tile that was drawn just before; nothing of that is stored.
 */
final class PathRehearsal {
    /**
     * Processor time of all threads that draw before it, which spares short renders the compiler's work: some 5 seconds
     * of processor time.
     */
    private static final long FIRST_NANOS = 16_000_000_000L;

    /** Limit of what is spent at once without drawing. */
    private static final long MOST_CREDIT_NANOS = 1_000_000_000L;

    /** The rehearsal gives up after this much of its own time, so that a render loses no more by it. */
    private static final long MOST_NANOS = 6_000_000_000L;

    /** A tile's samples that are followed, of a part of its pixels. */
    private static final int FEW_SAMPLES = 4;

    /**
     * Of all its pixels: with fewer paths their ends, in which few lanes run, would count for more than in a render.
     */
    private static final int MOST_SAMPLES = 32;

    /** Rehearsals of whole tiles that must be faster. */
    private static final int WINS = 3;

    /** Rehearsals that are at most this many times slower go on with more pixels. */
    private static final int NEARLY = 4;

    private final int threads;
    private volatile boolean isOver;
    private Optional<FrameInput> input = Optional.empty();
    private boolean isRunning;
    private int pixels = 2 * Lanes.COUNT;
    private int wins;
    private long tiles;
    private long kernelNanos;
    private long creditNanos;
    private long spentNanos;
    private long allNanos;
    private long nanosToBeat;

    /**
     * Starts to rehearse, or is over from the start.
     *
     * @param threads number of threads that draw
     * @param isOver whether made lanes draw from the start
     */
    PathRehearsal(int threads, boolean isOver) {
        this.threads = threads;
        this.isOver = isOver;
    }

    /** A clock that stands while the thread waits for the compiler or for a processor, where that is known. */
    static long clockNanos() {
        long processor = ProcessorTime.ofThisThread();
        return processor == 0 ? System.nanoTime() : processor;
    }

    /** Whether made lanes have been faster than packets and the kernel. */
    boolean isOver() {
        return isOver;
    }

    /**
     * Goes on, on the thread that rehearses, about as long as a tile was drawn.
     *
     * @param nanos how long the tile was drawn, by {@link #clockNanos}
     */
    @SuppressWarnings("ReferenceEquality") // inputs are immutable
    void goOn(PathTile paths, Drawing drawing, Tile tile, long nanos) {
        tiles++;
        kernelNanos += nanos;
        creditNanos = Math.min(creditNanos + nanos, MOST_CREDIT_NANOS);
        if (input.isEmpty() || input.get() != drawing.input) {
            input = Optional.of(drawing.input);
            isRunning = false;
        }
        // Tiles of less than usual time may have a part of the code alone, such as the sky.
        boolean isUsual = tile.left + Tile.SIDE <= drawing.width
                && tile.top + Tile.SIDE <= drawing.rows
                && nanos * tiles >= kernelNanos;
        while (!isOver
                && !drawing.stop.isAsked()
                && kernelNanos > FIRST_NANOS / threads
                && creditNanos > 0
                && allNanos < MOST_NANOS
                && (isRunning || isUsual)) {
            if (!isRunning) {
                int samples = Math.min(pixels < Tile.SIZE ? FEW_SAMPLES : MOST_SAMPLES, drawing.pixelSamples);
                paths.begin(drawing, pixels, samples, false);
                nanosToBeat = nanos * pixels * samples / ((long) Tile.SIZE * drawing.pixelSamples);
                spentNanos = 0;
                isRunning = true;
            }
            long start = clockNanos();
            paths.step(drawing);
            long spent = clockNanos() - start;
            spentNanos += spent;
            allNanos += spent;
            creditNanos -= spent;
            if (!paths.goesOn()) {
                isRunning = false;
                judge();
            }
        }
    }

    private void judge() {
        if (pixels < Tile.SIZE) {
            pixels *= spentNanos < NEARLY * nanosToBeat ? 2 : 1;
        } else {
            wins = spentNanos < nanosToBeat ? wins + 1 : 0;
            isOver = wins == WINS;
        }
    }
}
