package dev.twister.bench;

import dev.twister.engine.Engine;
import dev.twister.engine.EngineException;
import dev.twister.engine.JvmEngines;
import dev.twister.image.Frame;
import dev.twister.image.PictureSize;
import dev.twister.world.FrameInput;
import dev.twister.world.World;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Function;

/** Measures engines one after the other and holds each one's picture to sequential's. */
public final class Benchmark {
    /** The engine that all pictures are compared with. */
    public static final String REFERENCE = JvmEngines.SEQUENTIAL;

    private final Function<String, Engine> opener;
    private final BenchmarkPlan plan;
    private final World world;
    private final Optional<MotionPlan> motion;
    private final BenchmarkProgress progress;
    private final Map<PictureSize, int[]> references = new HashMap<>();
    private final List<Measurement> measurements = new ArrayList<>();
    private final List<EngineFailure> failures = new ArrayList<>();

    private Benchmark(
            Function<String, Engine> opener,
            BenchmarkPlan plan,
            World world,
            Optional<MotionPlan> motion,
            BenchmarkProgress progress) {
        this.opener = opener;
        this.plan = plan;
        this.world = world;
        this.motion = motion;
        this.progress = progress;
    }

    /**
     * Runs the plan. An engine that fails is in the report, and the others go on.
     *
     * @param opener opens the engine of an id
     * @param scene what the report calls the world's scene
     * @param world its settings' size, samples and bounces give way to the plan's
     * @param motion how its bodies move, where they do: each engine starts anew at each size
     * @throws EngineException where the reference cannot be drawn
     */
    public static BenchmarkReport run(
            Function<String, Engine> opener,
            BenchmarkPlan plan,
            String scene,
            World world,
            Optional<MotionPlan> motion,
            BenchmarkProgress progress) {
        Benchmark benchmark = new Benchmark(opener, plan, world, motion, progress);
        if (motion.isEmpty()) {
            benchmark.drawReferences();
        }
        plan.engines().forEach(benchmark::measure);
        return new BenchmarkReport(
                MachineInfo.ofThisMachine(), plan, scene, benchmark.measurements, benchmark.failures);
    }

    private void drawReferences() {
        try (Engine engine = opener.apply(REFERENCE)) {
            for (PictureSize size : plan.sizes()) {
                progress.begins("reference", size, 1);
                Frame frame = Frame.ofPixels(size.width(), size.height());
                engine.render(inputAt(size), frame);
                progress.drewFrame();
                references.put(size, frame.argb());
            }
        }
    }

    private void measure(String id) {
        EngineMeasuring measuring =
                new EngineMeasuring(plan.warmupFrames(), plan.frames(), plan.maxSeconds(), progress);
        try (Engine engine = opener.apply(id)) {
            AskedEngine asked = new AskedEngine(id, engine);
            for (PictureSize size : plan.sizes()) {
                Measurement measurement = motion.isPresent()
                        ? measureMoving(asked, size, motion.get())
                        : measureStanding(asked, size, measuring);
                measurements.add(measurement);
                progress.measured(measurement);
            }
        } catch (EngineException failure) {
            note(new EngineFailure(id, failure.getMessage()));
        } catch (OutOfMemoryError _) {
            note(new EngineFailure(id, EngineFailure.outOfMemory()));
        }
    }

    private void note(EngineFailure failure) {
        failures.add(failure);
        progress.failed(failure);
    }

    private Measurement measureStanding(AskedEngine asked, PictureSize size, EngineMeasuring measuring) {
        FrameInput input = inputAt(size);
        letCompile(asked, size, input);
        progress.begins(asked.id(), size, plan.warmupFrames() + plan.frames());
        return measuring.measure(asked, input, references.get(size));
    }

    private Measurement measureMoving(AskedEngine asked, PictureSize size, MotionPlan moving) {
        applySettings(size);
        return new MotionMeasuring(plan, moving, world, progress)
                .measure(asked, start -> letCompile(asked, size, start), this::drawReference);
    }

    private void letCompile(AskedEngine asked, PictureSize size, FrameInput input) {
        // What is compiled for one size is so for the next ones.
        if (plan.warmupFrames() > 0 && size.equals(plan.sizes().getFirst())) {
            new EngineWarmUp(plan.maxSeconds(), progress).run(asked, size, List.of(input));
        }
    }

    private int[] drawReference(FrameInput input) {
        try (Engine engine = opener.apply(REFERENCE)) {
            Frame frame = Frame.ofPixels(input.width(), input.height());
            engine.render(input, frame);
            return frame.argb();
        }
    }

    private FrameInput inputAt(PictureSize size) {
        applySettings(size);
        return world.snapshot();
    }

    private void applySettings(PictureSize size) {
        world.setSettings(world.settings()
                .withSize(size.width(), size.height())
                .withShadows(plan.shadowSamples())
                .withBounces(plan.bounces()));
    }
}
