package dev.twister.gui;

import dev.twister.engine.Engine;
import dev.twister.engine.EngineOffer;
import dev.twister.engine.Engines;
import dev.twister.gui.drawing.DrawnPicture;
import dev.twister.gui.model.ResolutionMode;
import dev.twister.image.Frame;
import dev.twister.scene.Scene;
import dev.twister.world.FrameInput;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.LockSupport;

/**
 * Measures the window against the engine alone: frames a second, time of the interface's thread, pulses. A program, run by
 * hand with the options of {@code .ci/window-test}: its arguments are pairs such as {@code vector:HD}.
 */
final class WindowFigures {
    private static final long WARM_UP_NANOS = TimeUnit.SECONDS.toNanos(6);
    private static final long NANOS = TimeUnit.SECONDS.toNanos(6);
    private static final double NANOS_PER_SECOND = 1e9;

    private WindowFigures() {}

    @SuppressWarnings("SystemOut") // a program for a person
    public static void main(String[] arguments) {
        System.out.println("engine      size   window FPS  engine FPS  ratio  pulses/s  longest ms  pulse mean/max ms");
        for (String argument : arguments) {
            String[] parts = argument.split(":", 2);
            EngineOffer offer = Engines.offers().stream()
                    .filter(one -> one.id().equals(parts[0]))
                    .findFirst()
                    .orElseThrow();
            System.out.println(measure(offer, ResolutionMode.valueOf(parts[1])));
        }
        System.exit(0);
    }

    private static String measure(EngineOffer offer, ResolutionMode size) {
        Scene scene = WindowScenes.shipped("benchmark");
        PulseRecord pulses = new PulseRecord();
        double windowRate;
        FrameInput input;
        try (WindowDriver driver = WindowDriver.open(scene, offer)) {
            driver.run(() -> driver.stage.setWidth(1280));
            driver.run(() -> driver.stage.setHeight(760));
            driver.run(() -> driver.studio.setResolution(size));
            driver.run(() -> driver.studio.refiningProperty().set(false));
            driver.awaitPicture(picture -> picture.engine().equals(offer.id()) && picture.isWhole());
            LockSupport.parkNanos(WARM_UP_NANOS);
            DrawnPicture first = newest(driver);
            driver.run(() -> driver.window.onPulse(pulses::add));
            LockSupport.parkNanos(NANOS);
            DrawnPicture last = driver.awaitPicture(picture -> picture.number() > first.number());
            windowRate = (last.number() - first.number())
                    * NANOS_PER_SECOND
                    / (last.finishedNanos() - first.finishedNanos());
            input = last.input();
        }
        double engineRate = engineAlone(offer, input);
        return String.format(
                Locale.ROOT,
                "%-11s %-6s %10.2f  %10.2f  %5.2f  %8.1f  %10.1f  %.3f / %.1f",
                offer.id(),
                size.label(),
                windowRate,
                engineRate,
                windowRate / engineRate,
                pulses.perSecond(),
                pulses.longestGapMillis(),
                pulses.meanMillis(),
                pulses.maxMillis());
    }

    private static DrawnPicture newest(WindowDriver driver) {
        return WindowDriver.call(() -> driver.studio.pictureProperty().get().orElseThrow());
    }

    private static double engineAlone(EngineOffer offer, FrameInput input) {
        Frame frame = Frame.ofPixels(input.width(), input.rows());
        try (Engine engine = offer.opener().get()) {
            long warm = System.nanoTime() + WARM_UP_NANOS / 2;
            do {
                engine.render(input, frame);
            } while (System.nanoTime() < warm);
            int frames = 0;
            long start = System.nanoTime();
            do {
                engine.render(input, frame);
                frames++;
            } while (System.nanoTime() - start < NANOS);
            return frames * NANOS_PER_SECOND / (System.nanoTime() - start);
        }
    }

    /** When pulses came and how long each kept the interface's thread. */
    private static final class PulseRecord {
        private final List<long[]> pulses = new ArrayList<>();

        void add(long startNanos, long endNanos) {
            pulses.add(new long[] {startNanos, endNanos});
        }

        double perSecond() {
            return (pulses.size() - 1) * NANOS_PER_SECOND / (pulses.getLast()[0] - pulses.getFirst()[0]);
        }

        double longestGapMillis() {
            long longest = 0;
            for (int i = 1; i < pulses.size(); i++) {
                longest = Math.max(longest, pulses.get(i)[0] - pulses.get(i - 1)[0]);
            }
            return longest / 1e6;
        }

        double meanMillis() {
            return pulses.stream()
                            .mapToLong(pulse -> pulse[1] - pulse[0])
                            .average()
                            .orElse(0)
                    / 1e6;
        }

        double maxMillis() {
            return pulses.stream().mapToLong(pulse -> pulse[1] - pulse[0]).max().orElse(0) / 1e6;
        }
    }
}
