package dev.twister.bench.benchmark;

import dev.twister.bench.Statistics;
import dev.twister.bench.benchmark.Measurement.DeviceTimes;
import dev.twister.engine.Engine;
import dev.twister.engine.EngineException;
import dev.twister.engine.Engines;
import dev.twister.engine.SettlingFrames;
import dev.twister.engine.UnknownEngineException;
import dev.twister.engine.auto.FastestEngine;
import dev.twister.image.Frame;
import dev.twister.image.FrameTimes;
import dev.twister.image.PictureSize;
import dev.twister.world.FrameInput;
import dev.twister.world.World;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import java.util.function.Function;
import java.util.stream.Collectors;

/** Measures engines one after the other and compares their pictures with the reference's. */
public final class Benchmark {
    /** Limit for the reference at each setting. */
    private static final double REFERENCE_SECONDS = 10;

    private final Function<String, Engine> opener;
    private final BenchmarkPlan plan;
    private final String scene;
    private final World world;
    private final Optional<MotionPlan> motion;
    private final BenchmarkProgress progress;
    private final MachineInfo machine = MachineInfo.ofThisMachine();
    private final Map<Setting, ReferencePicture> references = new HashMap<>();
    private final List<Measurement> measurements = new ArrayList<>();
    private final List<EngineFailure> failures = new ArrayList<>();

    private Benchmark(
            Function<String, Engine> opener,
            BenchmarkPlan plan,
            String scene,
            World world,
            Optional<MotionPlan> motion,
            BenchmarkProgress progress) {
        this.opener = opener;
        this.plan = plan;
        this.scene = scene;
        this.world = world;
        this.motion = motion;
        this.progress = progress;
    }

    /**
     * Opens an engine for measurement. {@value FastestEngine#AUTO} is resolved before, because frames of its stand-in
     * would be measured as its own.
     *
     * @throws UnknownEngineException if no engine has that name
     * @throws EngineException if the engine cannot be opened
     */
    public static Engine open(String id) {
        return id.equals(FastestEngine.AUTO)
                ? FastestEngine.ofThisMachine().openMeasured(Engines.offers())
                : Engines.open(id);
    }

    /**
     * Runs the plan. If an engine fails, the report says so, and the others are measured.
     *
     * @param opener opens an engine by its id
     * @param scene name of the world's scene in the report
     * @param world the plan overrides its settings' size, samples and bounces
     * @param motion how its bodies move, if they do; each engine starts anew at each setting
     * @throws EngineException if the reference cannot be rendered
     */
    public static BenchmarkReport run(
            Function<String, Engine> opener,
            BenchmarkPlan plan,
            String scene,
            World world,
            Optional<MotionPlan> motion,
            BenchmarkProgress progress) {
        Benchmark benchmark = new Benchmark(opener, plan, scene, world, motion, progress);
        if (motion.isEmpty()) {
            benchmark.drawReferences();
        }
        plan.engines().forEach(benchmark::measure);
        return benchmark.report(benchmark.pictures(), true);
    }

    private BenchmarkReport report(Map<Setting, Frame> pictures, boolean finished) {
        return new BenchmarkReport(machine, plan, scene, measurements, failures, pictures, finished);
    }

    private Map<Setting, Frame> pictures() {
        return plan.shown().stream()
                .filter(setting -> references.containsKey(setting)
                        && references.get(setting).isWhole())
                .collect(Collectors.toMap(
                        setting -> setting, setting -> references.get(setting).frame()));
    }

    private void drawReferences() {
        try (Engine engine = opener.apply(BenchmarkPlan.REFERENCE)) {
            for (Setting setting : plan.settings()) {
                progress.begins("reference", setting.size(), 1);
                // Pictures of the paper's page are whole.
                double seconds = !plan.hasOneFigure() && plan.shown().contains(setting)
                        ? Double.POSITIVE_INFINITY
                        : REFERENCE_SECONDS;
                references.put(setting, ReferencePicture.draw(engine, inputAt(setting), seconds));
                progress.drewFrame();
            }
        }
    }

    private void measure(String id) {
        try (Engine engine = opener.apply(id)) {
            AskedEngine asked = new AskedEngine(id, engine);
            for (Setting setting : plan.settings()) {
                if (isTooSlow(id, setting)) {
                    progress.leavesOut(id, setting, references.get(setting).secondsOfAll());
                } else {
                    measurements.add(measure(asked, setting));
                    progress.found(report(Map.of(), false));
                }
            }
        } catch (EngineException failure) {
            note(new EngineFailure(id, failure.getMessage()));
        } catch (OutOfMemoryError _) {
            note(new EngineFailure(id, EngineFailure.outOfMemory()));
        }
    }

    /** Whether one frame of the reference's engine, which is measured beside others, takes longer than the limit. */
    private boolean isTooSlow(String id, Setting setting) {
        ReferencePicture reference = references.get(setting);
        return id.equals(BenchmarkPlan.REFERENCE)
                && plan.engines().size() > 1
                && reference != null
                && reference.takesLongerThan(plan.maxSeconds());
    }

    private void note(EngineFailure failure) {
        failures.add(failure);
        progress.found(report(Map.of(), false));
    }

    private Measurement measure(AskedEngine asked, Setting setting) {
        world.setSettings(setting.over(world.settings()));
        try (MeasuredBodies bodies = new MeasuredBodies(world, motion)) {
            if (bodies.stepsToStart() > 0) {
                progress.begins(asked.id() + ", moving to its start,", setting.size(), bodies.stepsToStart());
            }
            bodies.moveToStart(progress::drewFrame);
            // Code compiled at one setting stays compiled for the next ones.
            if (plan.warmupFrames() > 0 && setting.equals(plan.settings().getFirst())) {
                List<FrameInput> inputs =
                        plan.shown().stream().map(this::inputAt).toList();
                new EngineWarmUp(plan.maxSeconds(), progress).run(asked, setting.size(), inputs);
                world.setSettings(setting.over(world.settings()));
            }
            return new EngineMeasuring(asked, plan, progress)
                    .measure(setting, bodies, input -> reference(setting, input));
        }
    }

    private ReferencePicture reference(Setting setting, FrameInput input) {
        ReferencePicture drawn = references.get(setting);
        if (drawn == null) {
            try (Engine engine = opener.apply(BenchmarkPlan.REFERENCE)) {
                drawn = ReferencePicture.draw(engine, input, REFERENCE_SECONDS);
            }
        }
        return drawn;
    }

    /** The input at a setting, with the bodies at their current positions. */
    private FrameInput inputAt(Setting setting) {
        world.setSettings(setting.over(world.settings()));
        return world.snapshot();
    }

    /**
     * Warms up an engine before its first measured frame. Full-size frames alone are too few for the JIT compiler on a
     * slow machine, and for the code around a kernel that takes less than a millisecond.
     *
     * @param maxSeconds limit per input for small frames; at least one is rendered
     */
    record EngineWarmUp(double maxSeconds, BenchmarkProgress progress) {
        private static final double NANOS_PER_SECOND = TimeUnit.SECONDS.toNanos(1);

        /**
         * Renders small frames of each input until their times settle. A device renders its first frames, in which it
         * compiles and tries work-groups, in the size that is measured.
         */
        void run(AskedEngine asked, PictureSize size, List<FrameInput> inputs) {
            progress.begins(asked.id() + ", warming up,", size, 1);
            Duration each = Duration.ofNanos((long) (maxSeconds * NANOS_PER_SECOND));
            for (FrameInput input : inputs) {
                if (asked.isDevice()) {
                    Frame whole = Frame.ofPixels(input.width(), input.rows());
                    for (int frame = 0; frame < AskedEngine.FIRST_OF_A_DEVICE; frame++) {
                        asked.engine().render(input, whole);
                    }
                }
                new SettlingFrames(asked.engine(), SettlingFrames.small(input)).settle(each, () -> false);
            }
            progress.drewFrame();
        }
    }

    /**
     * An engine with the name by which it was requested: {@value FastestEngine#AUTO} opens another engine, which may be
     * measured too.
     *
     * @param id the name in the report
     */
    record AskedEngine(String id, Engine engine) {
        /** In which the TornadoVM engine tries work-groups: {@code WorkGroups}. */
        private static final int FIRST_OF_A_DEVICE = 6;

        /** The engine's device, preceded by the engine's own id if that differs. */
        String device() {
            return (engine.id().equals(id) ? "" : engine.id() + ": ") + engine.device();
        }

        /** Whether the engine runs on a device. */
        boolean isDevice() {
            return Engines.isDevice(engine.id());
        }
    }

    /** Measures an engine at a setting: warm-up frames, then measured ones. */
    private record EngineMeasuring(AskedEngine asked, BenchmarkPlan plan, BenchmarkProgress progress) {
        private static final double NANOS_PER_MILLI = 1e6;
        private static final double NANOS_PER_SECOND = 1e9;

        /**
         * Renders the bodies at rest, then in motion if they move: the same frames for every engine, regardless of the
         * number of warm-up frames.
         *
         * @param reference renders the reference of the last frame
         */
        Measurement measure(Setting setting, MeasuredBodies bodies, Function<FrameInput, ReferencePicture> reference) {
            progress.begins(asked.id(), setting.size(), plan.framesEach());
            Frame frame = Frame.ofPixels(setting.size().width(), setting.size().height());
            long start = System.nanoTime();
            int warmups = 0;
            while (warmups < plan.warmupFrames()
                    && (warmups < fewestWarmups() || isWithin(start, plan.maxSeconds() / 2))) {
                draw(bodies.rehearse(), frame);
                warmups++;
            }
            // Cleared, so that pixels that an engine does not write are detected.
            Arrays.fill(frame.argb(), 0);
            List<FrameTimes> times = new ArrayList<>();
            while (times.size() < plan.frames() && (times.isEmpty() || isWithin(start, plan.maxSeconds()))) {
                draw(bodies.next(), frame);
                times.add(frame.times());
            }
            return new Measurement(
                    asked.id(),
                    asked.device(),
                    setting,
                    bodies.input().bodyCount(),
                    warmups,
                    Statistics.ofNanos(
                            times.stream().mapToLong(FrameTimes::totalNanos).toArray()),
                    DeviceTimes.meanOf(times),
                    reference.apply(bodies.input()).compare(frame.argb()),
                    bodies.times(times.stream()
                            .map(time -> time.totalNanos() / NANOS_PER_MILLI)
                            .toList()));
        }

        private void draw(FrameInput input, Frame frame) {
            asked.engine().render(input, frame);
            progress.drewFrame();
        }

        private int fewestWarmups() {
            return asked.isDevice() ? AskedEngine.FIRST_OF_A_DEVICE : 1;
        }

        private static boolean isWithin(long start, double seconds) {
            return (System.nanoTime() - start) / NANOS_PER_SECOND < seconds;
        }
    }
}
