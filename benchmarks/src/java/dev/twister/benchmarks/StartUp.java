package dev.twister.benchmarks;

import dev.twister.engine.Engine;
import dev.twister.engine.Engines;
import dev.twister.image.Frame;
import dev.twister.image.PictureSize;
import dev.twister.scene.Rendering;
import dev.twister.world.FrameInput;
import java.lang.management.ManagementFactory;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;

/**
 * Measures the cold start of the process that runs it, in milliseconds since the JVM began. Run by
 * {@code benchmarks/start-up}, which says what the arguments are: an engine, a size, and seconds.
 */
public final class StartUp {
    /** What counts as full speed: this share of the most frames per second that last. */
    private static final double FULL_SPEED = 0.9;

    /** How many frames stand for the speed at a time. */
    private static final int WINDOW = 5;

    /** How many stand for a speed that lasts. Not those at the end: devices may be tried beside them. */
    private static final int LASTING = 100;

    private static final double NANOS_PER_MILLI = 1e6;

    private StartUp() {}

    @SuppressWarnings("SystemOut") // a command's result
    public static void main(String[] arguments) {
        PictureSize size = PictureSize.parse(arguments[1]);
        Duration length = Duration.ofSeconds(Long.parseLong(arguments[2]));
        FrameInput input = BenchmarkScene.paper(Rendering.DEFAULT.withSize(size.width(), size.height()))
                .snapshot();
        Frame frame = Frame.ofPixels(size.width(), size.height());
        List<Long> ends = new ArrayList<>();
        List<Long> nanos = new ArrayList<>();
        String first = "";
        try (Engine engine = Engines.open(arguments[0])) {
            do {
                engine.render(input, frame);
                ends.add(millisSinceStart());
                nanos.add(frame.times().totalNanos());
                first = first.isEmpty() ? engine.id() : first;
            } while (millisSinceStart() < length.toMillis());
            long full = fullSpeed(nanos);
            System.out.printf(
                    "first frame, by %s: %d ms%n%.0f %% of full speed: %d ms%nfull speed, by %s: %.1f ms per frame%n",
                    first,
                    ends.getFirst(),
                    100 * FULL_SPEED,
                    ends.get(firstAtSpeed(nanos, full)),
                    engine.id(),
                    full / NANOS_PER_MILLI);
        }
    }

    /** The best median of {@link #LASTING} frames one after the other. */
    private static long fullSpeed(List<Long> nanos) {
        return IntStream.rangeClosed(0, Math.max(0, nanos.size() - LASTING))
                .mapToLong(from -> medianFrom(nanos, from, LASTING))
                .min()
                .orElseThrow();
    }

    /** The first frame of {@link #WINDOW} that are, like itself, nearly at full speed. */
    private static int firstAtSpeed(List<Long> nanos, long full) {
        int at = 0;
        while (at < nanos.size() - 1 && FULL_SPEED * Math.max(nanos.get(at), medianFrom(nanos, at, WINDOW)) > full) {
            at++;
        }
        return at;
    }

    private static long medianFrom(List<Long> nanos, int from, int count) {
        List<Long> sorted = nanos.subList(from, Math.min(nanos.size(), from + count)).stream()
                .sorted()
                .toList();
        return sorted.get(sorted.size() / 2);
    }

    private static long millisSinceStart() {
        return System.currentTimeMillis() - ManagementFactory.getRuntimeMXBean().getStartTime();
    }
}
