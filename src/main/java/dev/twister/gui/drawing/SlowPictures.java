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
 * Draws pictures that take long in bands of rows, so that one can be left when it is not wanted any more: one thread
 * takes many seconds for a picture of 3840 x 2160. Those that do not take long are drawn in one go, as bands cost time,
 * and so are those of engines that are not made for bands. Used by one thread.
 */
final class SlowPictures {
    /** How long a band should take. */
    private static final long BAND_NANOS = TimeUnit.MILLISECONDS.toNanos(100);

    /** Pictures of fewer pixels are not worth it: the slowest engine takes half a second for this number. */
    private static final int FEWEST_PIXELS = 1 << 16;

    /**
     * Of a picture of which nothing is known about this number of pixels is rendered first, of more than
     * {@link #FEW_BODIES} fewer.
     */
    private static final int FIRST_PIXELS = 1 << 14;

    /** The pixels of a crowd take longer, most of all before the JVM has compiled what they run. */
    private static final int FEW_BODIES = 32;

    private final LongSupplier clock;
    private Optional<Pace> pace = Optional.empty();

    /**
     * What the time of a picture hangs on most, beside its samples a pixel, with which it grows. Of a scene only the
     * room for bodies, and the meshes: more bodies come one by one, and the next picture of the same scene is much like
     * the last.
     */
    private record Work(Engine engine, int width, int rows, int room, int meshFloats, int shadowSamples, int bounces) {
        static Work of(Engine engine, FrameInput input) {
            return new Work(
                    engine,
                    input.width(),
                    input.rows(),
                    input.bodies().room(),
                    input.bodies().meshes().length,
                    input.shadowSamples(),
                    input.bounces());
        }
    }

    private record Pace(Work work, double nanosARowAndSample) {}

    SlowPictures(LongSupplier clock) {
        this.clock = clock;
    }

    /** How long the last picture took, where it was one like that and had enough pixels to be left; else 0. */
    long knownNanos(Engine engine, FrameInput input) {
        return (long) (nanosARow(engine, input) * input.rows());
    }

    /** Whether nothing is known of a picture whose meshes may make it take long. */
    boolean mayTakeLong(Engine engine, FrameInput input) {
        return input.bodies().firstMesh() > 0 && isLeft(engine, input) && nanosARow(engine, input) == 0;
    }

    /** Takes it that a picture of which nothing is known would take so long. */
    void guess(Engine engine, FrameInput input, long nanos) {
        pace = Optional.of(new Pace(Work.of(engine, input), nanos / ((double) input.rows() * input.samplesPerPixel())));
    }

    /** Whether such a picture is drawn in bands, between which it can be left. */
    private static boolean isLeft(Engine engine, FrameInput input) {
        return engine.drawsBandsInProportion() && input.width() * input.rows() >= FEWEST_PIXELS;
    }

    /** 0 where it is not known. */
    private double nanosARow(Engine engine, FrameInput input) {
        Work work = Work.of(engine, input);
        return pace.filter(known -> known.work().equals(work))
                .map(known -> known.nanosARowAndSample() * input.samplesPerPixel())
                .orElse(0.0);
    }

    /**
     * Draws a picture.
     *
     * @param leave whether to leave the picture, that number of nanoseconds before it would be done; asked between
     *     bands
     * @return whether the picture was drawn, and not left
     */
    boolean draw(Engine engine, FrameInput input, Frame frame, LongPredicate leave) {
        int height = input.rows();
        if (!isLeft(engine, input)) {
            engine.render(input, frame);
            return true;
        }
        double nanosARow = nanosARow(engine, input);
        long start = clock.getAsLong();
        long before = start;
        FrameTimes times = FrameTimes.NONE;
        int drawn = 0;
        while (drawn < height) {
            int rows = nanosARow == 0 ? firstRows(input) : rows(nanosARow, height - drawn);
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
            // Rows are not alike: the next ones are like the last, more than like the sky above.
            long now = clock.getAsLong();
            nanosARow = Math.max(1, (double) (now - before) / rows);
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

    private static int rows(double nanosARow, int left) {
        return nanosARow * left < 2 * BAND_NANOS ? left : (int) Math.clamp(BAND_NANOS / nanosARow, 1, left);
    }
}
