package dev.twister.gui;

import dev.twister.engine.Engine;
import dev.twister.engine.EngineOffer;
import dev.twister.engine.Engines;
import dev.twister.gui.drawing.DrawingLoop;
import dev.twister.gui.drawing.DrawnPicture;
import dev.twister.gui.drawing.ResolutionMode;
import dev.twister.gui.studio.Studio;
import dev.twister.image.Frame;
import dev.twister.scene.Scene;
import dev.twister.world.FrameInput;
import dev.twister.world.animation.CameraMotion;
import dev.twister.world.animation.Turn;
import java.lang.management.ManagementFactory;
import java.lang.management.ThreadInfo;
import java.lang.management.ThreadMXBean;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.TreeMap;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.LockSupport;
import java.util.stream.Collectors;

/**
 * Measures the window against the engine alone, by turns: frames a second, pulses, and where the processor's time goes.
 * A program, run by hand on a screen: its arguments are such as {@code vector:HD}, where all is at rest, and
 * {@code vector:HD:moving}, where each pulse asks for another picture. With {@code -XX:ActiveProcessorCount=1} an
 * engine draws on one thread.
 */
final class WindowFigures {
    /** Short and many: another's work on the machine comes and goes. The first half is for the compiler. */
    private static final int ROUNDS = Integer.getInteger("twister.rounds", 12);

    private static final long WARM_UP_NANOS = TimeUnit.MILLISECONDS.toNanos(500);
    private static final long NANOS = TimeUnit.SECONDS.toNanos(Integer.getInteger("twister.seconds", 2));
    private static final double NANOS_PER_SECOND = 1e9;
    private static final double SWAY_SECONDS = 1e-4;

    /** Room for 720p, pixel for pixel. */
    private static final int WIDTH = Integer.getInteger("twister.width", 1280);

    private static final int HEIGHT = Integer.getInteger("twister.height", 720);

    private WindowFigures() {}

    @SuppressWarnings("SystemOut") // a program for a person
    public static void main(String[] arguments) {
        for (String argument : arguments) {
            String[] parts = argument.split(":", 3);
            EngineOffer offer = Engines.offers().stream()
                    .filter(one -> one.id().equals(parts[0]))
                    .findFirst()
                    .orElseThrow();
            List<Round> rounds = new ArrayList<>();
            for (int round = 0; round < ROUNDS; round++) {
                rounds.add(measure(offer, ResolutionMode.valueOf(parts[1]), parts.length == 3));
                System.out.println(rounds.getLast().text());
            }
            System.out.printf(
                    Locale.ROOT,
                    "%s: median ratio of the last %d rounds %.3f%n",
                    argument,
                    ROUNDS - ROUNDS / 2,
                    median(rounds.subList(ROUNDS / 2, ROUNDS)));
        }
        System.exit(0);
    }

    private record Round(double ratio, String text) {}

    private static double median(List<Round> rounds) {
        double[] ratios = rounds.stream().mapToDouble(Round::ratio).sorted().toArray();
        return (ratios[(ratios.length - 1) / 2] + ratios[ratios.length / 2]) / 2;
    }

    private static Round measure(EngineOffer offer, ResolutionMode size, boolean moving) {
        Scene scene = WindowScenes.shipped("benchmark");
        PulseRecord pulses = new PulseRecord();
        double windowRate;
        String processors;
        FrameInput input;
        try (WindowDriver driver = WindowDriver.open(scene, offer)) {
            driver.run(() -> driver.stage.setWidth(WIDTH));
            driver.run(() -> driver.stage.setHeight(HEIGHT));
            driver.await(() -> Math.round(driver.pictureOnScreen().getWidth()) == WIDTH);
            double around = HEIGHT - Math.rint(driver.pictureOnScreen().getHeight());
            driver.run(() -> driver.stage.setHeight(HEIGHT + around));
            driver.await(() -> Math.round(driver.pictureOnScreen().getHeight()) == HEIGHT);
            driver.run(() -> driver.studio.setResolution(size));
            driver.run(() -> driver.studio.refiningProperty().set(false));
            driver.await(() -> driver.studio.drawingProperty().get().equals(DrawingLoop.Status.QUIET));
            driver.awaitPicture(picture -> picture.engine().equals(offer.id()) && picture.isWhole());
            if (moving) {
                driver.run(() -> driver.window.onPulse((_, _) -> sway(driver.studio)));
            }
            LockSupport.parkNanos(WARM_UP_NANOS);
            DrawnPicture first = newest(driver);
            driver.run(() -> driver.window.onPulse((start, end) -> {
                pulses.add(start, end);
                if (moving) {
                    sway(driver.studio);
                }
            }));
            ProcessorTimes before = ProcessorTimes.now();
            LockSupport.parkNanos(NANOS);
            processors = ProcessorTimes.now().since(before);
            DrawnPicture last = driver.awaitPicture(picture -> picture.number() > first.number());
            windowRate = (last.number() - first.number())
                    * NANOS_PER_SECOND
                    / (last.finishedNanos() - first.finishedNanos());
            input = last.input();
        }
        double engineRate = engineAlone(offer, input);
        String text = String.format(
                Locale.ROOT,
                "%s %s: %.2f FPS in the window, %.2f alone, ratio %.2f; %.1f pulses a second, longest gap %.1f ms,"
                        + " interface's thread %.3f ms a pulse, %.1f at most%n    processors: %s",
                offer.id(),
                size.label(),
                windowRate,
                engineRate,
                windowRate / engineRate,
                pulses.perSecond(),
                pulses.longestGapMillis(),
                pulses.meanMillis(),
                pulses.maxMillis(),
                processors);
        return new Round(windowRate / engineRate, text);
    }

    /** To and fro, so that all pictures take the same time; by less than a pixel. */
    private static void sway(Studio studio) {
        studio.moveCamera(camera ->
                CameraMotion.turn(camera, new Turn(camera.yawDegrees() > 0 ? -1 : 1, 0, false), SWAY_SECONDS));
    }

    private static DrawnPicture newest(WindowDriver driver) {
        return WindowDriver.call(() -> driver.studio.pictureProperty().get().orElseThrow());
    }

    private static double engineAlone(EngineOffer offer, FrameInput input) {
        Frame frame = Frame.ofPixels(input.width(), input.rows());
        try (Engine engine = offer.opener().get()) {
            long warm = System.nanoTime() + WARM_UP_NANOS;
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

    /**
     * Processor time so far.
     *
     * @param nanos when it was looked at
     * @param ofGroup in nanoseconds, by the kind of thread or the other process
     */
    private record ProcessorTimes(long nanos, Map<String, Long> ofGroup) {
        static ProcessorTimes now() {
            Map<String, Long> ofGroup = new TreeMap<>();
            ThreadMXBean threads = ManagementFactory.getThreadMXBean();
            for (ThreadInfo thread : threads.getThreadInfo(threads.getAllThreadIds())) {
                if (thread != null) {
                    ofGroup.merge(
                            group(thread.getThreadName()),
                            Math.max(0, threads.getThreadCpuTime(thread.getThreadId())),
                            Long::sum);
                }
            }
            long own = ProcessHandle.current()
                    .info()
                    .totalCpuDuration()
                    .orElse(Duration.ZERO)
                    .toNanos();
            long java = ofGroup.values().stream().mapToLong(Long::longValue).sum();
            ofGroup.put("compilers and collectors", own - java);
            ofGroup.put(
                    "screen",
                    ProcessHandle.allProcesses()
                            .map(ProcessHandle::info)
                            .filter(info -> info.command().orElse("").contains("Xvfb"))
                            .mapToLong(info -> info.totalCpuDuration()
                                    .orElse(Duration.ZERO)
                                    .toNanos())
                            .sum());
            return new ProcessorTimes(System.nanoTime(), ofGroup);
        }

        private static String group(String thread) {
            return switch (thread) {
                case String name when name.startsWith("JavaFX Application") -> "interface";
                case String name when name.startsWith("QuantumRenderer") -> "JavaFX's renderer";
                case String name when name.startsWith("Prism") -> "JavaFX's painter";
                case String name
                when name.startsWith("drawing") || name.startsWith("twister-") || name.startsWith("ForkJoin") ->
                    "engine";
                default -> "other threads";
            };
        }

        /** In cores: 1 is one core kept busy. */
        String since(ProcessorTimes before) {
            return ofGroup.entrySet().stream()
                    .map(group -> String.format(
                            Locale.ROOT,
                            "%s %.2f",
                            group.getKey(),
                            (group.getValue() - before.ofGroup().getOrDefault(group.getKey(), 0L))
                                    / (double) (nanos - before.nanos())))
                    .collect(Collectors.joining(", "));
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
