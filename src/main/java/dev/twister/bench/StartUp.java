package dev.twister.bench;

import dev.twister.engine.Engine;
import dev.twister.engine.EngineException;
import dev.twister.image.Frame;
import dev.twister.world.FrameInput;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.function.LongSupplier;
import java.util.function.Supplier;
import java.util.stream.IntStream;

/** How a process that has just begun comes to its first frame, and to its full speed. */
public final class StartUp {
    /** What counts as full speed: this share of the most frames a second that last. */
    static final double FULL_SPEED = 0.9;

    /** How many frames stand for the speed at a time. */
    private static final int WINDOW = 5;

    /**
     * How many frames one after the other stand for a speed that lasts. Not those at the end: devices are tried beside them
     * where that was never done.
     */
    private static final int LASTING = 100;

    private final LongSupplier nanosSinceStart;
    private final List<Long> ends = new ArrayList<>();
    private final List<Long> frameNanos = new ArrayList<>();

    /**
     * Measures nothing yet.
     *
     * @param nanosSinceStart the clock, which began with the process
     */
    public StartUp(LongSupplier nanosSinceStart) {
        this.nanosSinceStart = nanosSinceStart;
    }

    /**
     * Opens the engine and draws the input for so long.
     *
     * @param drew is run after each frame
     * @throws EngineException where the engine cannot be opened or fails
     */
    public StartUpReport run(Supplier<Engine> opener, FrameInput input, Duration length, Runnable drew) {
        try (Engine engine = opener.get()) {
            Frame frame = Frame.ofPixels(input.width(), input.height());
            draw(engine, input, frame, drew);
            String first = engine.id();
            while (nanosSinceStart.getAsLong() < length.toNanos()) {
                draw(engine, input, frame, drew);
            }
            return report(first, engine.id());
        }
    }

    private void draw(Engine engine, FrameInput input, Frame frame, Runnable drew) {
        engine.render(input, frame);
        ends.add(nanosSinceStart.getAsLong());
        frameNanos.add(frame.times().totalNanos());
        drew.run();
    }

    private StartUpReport report(String firstEngine, String lastEngine) {
        int frames = ends.size();
        long full = IntStream.rangeClosed(0, Math.max(0, frames - LASTING))
                .mapToLong(from -> median(frameNanos.subList(from, Math.min(frames, from + LASTING))))
                .min()
                .orElseThrow();
        int at = 0;
        while (at < frames - 1 && FULL_SPEED * Math.max(frameNanos.get(at), median(windowFrom(at))) > full) {
            at++;
        }
        return new StartUpReport(
                firstEngine,
                Duration.ofNanos(ends.getFirst()),
                lastEngine,
                Duration.ofNanos(full),
                Duration.ofNanos(ends.get(at)),
                frames);
    }

    private List<Long> windowFrom(int at) {
        return frameNanos.subList(at, Math.min(frameNanos.size(), at + WINDOW));
    }

    private static long median(List<Long> nanos) {
        List<Long> sorted = nanos.stream().sorted().toList();
        return sorted.get(sorted.size() / 2);
    }
}
