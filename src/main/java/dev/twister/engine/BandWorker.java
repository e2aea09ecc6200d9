package dev.twister.engine;

import dev.twister.image.Frame;
import dev.twister.image.FrameStop;
import dev.twister.world.FrameInput;
import java.util.HashSet;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.TimeUnit;

/**
 * One of several engines that render bands of the same frame. An engine whose time is in proportion to the rows takes
 * bands of any height. Any other one, for which each call costs much besides, always renders the same number of rows.
 */
final class BandWorker {
    /** Fewer rows keep the processor's threads from sharing a band evenly. */
    private static final int FEWEST_ROWS = 16;

    /** Part of a frame that an engine of unknown speed renders at a time. */
    private static final double FIRST_PART = 0.125;

    /** Bands that an engine renders of its share of a frame. */
    private static final int BANDS = 2;

    /** Weight of the newest band in the measured speed. */
    private static final double NEWEST = 0.25;

    private final Engine engine;
    private volatile double rowsASecond;
    private int frameRows;
    private int fixedRows;
    private boolean sizedBySpeed;

    /** The kinds of frames that the engine has compiled for; the first band of each takes longer. */
    private final Set<Boolean> compiledByLinear = new HashSet<>();

    BandWorker(Engine engine) {
        this.engine = engine;
    }

    Engine engine() {
        return engine;
    }

    /** The measured speed; 0 if it is not known yet. */
    double rowsASecond() {
        return rowsASecond;
    }

    /**
     * Renders bands until none are left.
     *
     * @param input of the whole frame
     * @param share of the frame that this engine renders by its speed, from 0 to 1; empty if some speed is unknown
     */
    void render(FrameInput input, FrameStop stop, BandQueue queue, Optional<Double> share) {
        if (engine.drawsBandsInProportion()) {
            double part = share.orElse(FIRST_PART) / BANDS;
            for (var band = queue.takeFromBottom(part, FEWEST_ROWS);
                    band.isPresent();
                    band = queue.takeFromBottom(part, FEWEST_ROWS)) {
                renderExactly(input, stop, band.get());
            }
        } else {
            int rows = fixedRows(queue.rows(), share);
            for (var band = queue.takeFromTop(rows); band.isPresent(); band = queue.takeFromTop(rows)) {
                renderAround(input, stop, band.get());
            }
        }
    }

    /** Chosen once without and once with known speeds. */
    private int fixedRows(int rows, Optional<Double> share) {
        if (rows != frameRows || (share.isPresent() && !sizedBySpeed)) {
            frameRows = rows;
            compiledByLinear.clear();
            sizedBySpeed = share.isPresent();
            double part = share.map(known -> known / BANDS).orElse(FIRST_PART);
            fixedRows = Math.clamp((int) Math.ceil(part * rows), Math.min(FEWEST_ROWS, rows), rows);
        }
        return fixedRows;
    }

    private void renderExactly(FrameInput input, FrameStop stop, BandQueue.Band band) {
        Frame frame = stop.frame();
        Frame part = frame.ofRows(band.rows());
        part.stopWhen(stop::isAsked);
        engine.render(input.band(input.firstRow() + band.first(), band.rows()), part);
        frame.put(part, band.first());
        measure(part, band.rows());
    }

    /** Renders the fixed number of rows, in which the band's are, and keeps the band's. */
    private void renderAround(FrameInput input, FrameStop stop, BandQueue.Band band) {
        int first = Math.min(band.first(), frameRows - fixedRows);
        Frame frame = stop.frame();
        Frame part = frame.ofRows(fixedRows);
        part.stopWhen(stop::isAsked);
        engine.render(input.band(input.firstRow() + first, fixedRows), part);
        frame.put(part.rows(band.first() - first, band.rows()), band.first());
        if (!compiledByLinear.add(frame.isLinear())) {
            measure(part, fixedRows);
        }
    }

    private void measure(Frame part, int rows) {
        double newest = (double) rows
                * TimeUnit.SECONDS.toNanos(1)
                / Math.max(1, part.times().totalNanos());
        rowsASecond = rowsASecond == 0 ? newest : rowsASecond + NEWEST * (newest - rowsASecond);
    }
}
