package dev.twister.gui.drawing;

import dev.twister.engine.Engine;
import dev.twister.image.Frame;
import dev.twister.image.FrameTimes;
import dev.twister.world.FrameInput;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import java.util.function.LongPredicate;
import java.util.function.LongSupplier;

/**
 * Draws slow pictures in bands of rows, so that they can be abandoned: one thread takes many seconds for a picture of
 * 3840 x 2160. Fast pictures are drawn in one call, because bands cost time, and so are those of engines that do not
 * support bands. Used by one thread.
 */
final class BandRenderer {
    /** Time of a band. */
    private static final long BAND_NANOS = TimeUnit.MILLISECONDS.toNanos(100);

    /** Smaller pictures are drawn in one call: the slowest engine takes half a second for this number of pixels. */
    private static final int FEWEST_PIXELS = 1 << 16;

    /**
     * Number of pixels drawn first if the time of a picture is unknown; fewer with more than {@link #FEW_BODIES}
     * bodies.
     */
    private static final int FIRST_PIXELS = 1 << 14;

    /** Many bodies take longer per pixel, above all before the JVM has compiled their code. */
    private static final int FEW_BODIES = 32;

    /** A band has at most this many times the rows of the one before. */
    private static final int GROWTH = 4;

    private final LongSupplier clock;
    private Optional<Pace> pace = Optional.empty();

    /**
     * The properties that decide the time per pixel and sample. Of a scene only the capacity for bodies and the meshes
     * count: edits add bodies one by one, which changes little.
     */
    private record Work(
            Engine engine,
            int width,
            int rows,
            int room,
            int meshFloats,
            int shadowSamples,
            int bounces,
            boolean traced) {
        static Work of(Engine engine, FrameInput input) {
            return new Work(
                    engine,
                    input.width(),
                    input.rows(),
                    input.bodies().room(),
                    input.bodies().meshes().length,
                    input.shadowSamples(),
                    input.bounces(),
                    input.tracesPaths());
        }
    }

    private record Pace(Work work, double nanosARowAndSample) {}

    BandRenderer(LongSupplier clock) {
        this.clock = clock;
    }

    /** Time of the last picture if it was of this kind and large enough; else 0. */
    long knownNanos(Engine engine, FrameInput input) {
        return (long) (nanosARow(engine, input) * input.rows());
    }

    /** Whether the time of a picture is unknown, and meshes or path tracing may make it slow. */
    boolean mayTakeLong(Engine engine, FrameInput input) {
        return (input.bodies().firstMesh() > 0 || input.tracesPaths())
                && isLeft(engine, input)
                && nanosARow(engine, input) == 0;
    }

    /** Assumes this time for a picture whose time is unknown. */
    void guess(Engine engine, FrameInput input, long nanos) {
        pace = Optional.of(new Pace(Work.of(engine, input), nanos / ((double) input.rows() * input.samplesPerPixel())));
    }

    /** Whether the picture is drawn in bands. */
    private static boolean isLeft(Engine engine, FrameInput input) {
        return engine.drawsBandsInProportion() && input.width() * input.rows() >= FEWEST_PIXELS;
    }

    /** 0 if unknown. */
    private double nanosARow(Engine engine, FrameInput input) {
        Work work = Work.of(engine, input);
        return pace.filter(known -> known.work().equals(work))
                .map(known -> known.nanosARowAndSample() * input.samplesPerPixel())
                .orElse(0.0);
    }

    /**
     * Draws a picture.
     *
     * @param leave whether to abandon the picture, given the nanoseconds that are left; called between bands
     * @return whether the picture was finished
     */
    boolean draw(Engine engine, FrameInput input, Frame frame, LongPredicate leave) {
        int height = input.rows();
        if (!isLeft(engine, input)) {
            engine.render(input, frame);
            return true;
        }
        double known = nanosARow(engine, input);
        double nanosARow = known;
        long start = clock.getAsLong();
        long before = start;
        FrameTimes times = FrameTimes.NONE;
        int drawn = 0;
        int most = height;
        while (drawn < height) {
            int rows = nanosARow == 0 ? firstRows(input) : rows(nanosARow, height - drawn, most);
            if (rows == height) {
                engine.render(input, frame);
                times = frame.times();
            } else {
                Frame band = frame.ofRows(rows);
                engine.render(input.band(drawn, rows), band);
                frame.put(band, drawn);
                times = times.plus(band.times());
            }
            drawn += rows;
            // Rows differ: the next ones are more like the last than like the sky above, which is fast.
            long now = clock.getAsLong();
            nanosARow = Math.max(Math.max(1, known), (double) (now - before) / rows);
            most = GROWTH * rows;
            before = now;
            if (drawn < height && leave.test((long) (nanosARow * (height - drawn)))) {
                return false;
            }
        }
        frame.setTimes(times);
        double samples = (double) height * input.samplesPerPixel();
        pace = Optional.of(new Pace(Work.of(engine, input), (before - start) / samples));
        return true;
    }

    private static int firstRows(FrameInput input) {
        int pixels = (int) ((long) FIRST_PIXELS
                * FEW_BODIES
                / Math.max(FEW_BODIES, input.bodies().room()));
        return Math.clamp(pixels / input.width(), 1, input.rows());
    }

    private static int rows(double nanosARow, int left, int most) {
        return nanosARow * left < 2 * BAND_NANOS && left <= most
                ? left
                : (int) Math.clamp(BAND_NANOS / nanosARow, 1, Math.min(left, most));
    }
}
