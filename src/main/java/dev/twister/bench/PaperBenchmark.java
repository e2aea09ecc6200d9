package dev.twister.bench;

import dev.twister.engine.Engine;
import dev.twister.engine.EngineException;
import dev.twister.image.Frame;
import dev.twister.world.FrameInput;
import dev.twister.world.World;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Consumer;
import java.util.function.Function;

/** Repeats the paper's evaluation. */
public final class PaperBenchmark {
    /** An engine's first setting would pay for its compiler: before it comes a warm-up of this many settings' time. */
    private static final int FIRST_WARM_UP_SETTINGS = 3;

    private final Function<String, Engine> opener;
    private final PaperPlan plan;
    private final World world;
    private final BenchmarkProgress progress;
    private final Consumer<PaperReport> soFar;
    private final String scene;
    private final MachineInfo machine = MachineInfo.ofThisMachine();
    private final Map<PaperSetting, Frame> references = new LinkedHashMap<>();
    private final List<Measurement> measurements = new ArrayList<>();
    private final List<EngineFailure> failures = new ArrayList<>();

    private PaperBenchmark(
            Function<String, Engine> opener,
            PaperPlan plan,
            String scene,
            World world,
            BenchmarkProgress progress,
            Consumer<PaperReport> soFar) {
        this.opener = opener;
        this.plan = plan;
        this.scene = scene;
        this.world = world;
        this.progress = progress;
        this.soFar = soFar;
    }

    /**
     * Runs the plan. An engine that fails is in the report, and the others go on.
     *
     * @param opener opens the engine of an id
     * @param scene what the report calls the world's scene
     * @param world its settings' size, samples and bounces give way to the plan's
     * @param soFar takes an unfinished report without pictures after each measurement and each failure
     * @throws EngineException where the reference cannot be drawn
     */
    public static PaperReport run(
            Function<String, Engine> opener,
            PaperPlan plan,
            String scene,
            World world,
            BenchmarkProgress progress,
            Consumer<PaperReport> soFar) {
        PaperBenchmark benchmark = new PaperBenchmark(opener, plan, scene, world, progress, soFar);
        benchmark.drawReferences();
        plan.engines().forEach(benchmark::measure);
        List<PaperPicture> pictures = plan.shown().stream()
                .map(setting -> new PaperPicture(setting, benchmark.references.get(setting)))
                .toList();
        return benchmark.report(pictures, true);
    }

    private PaperReport report(List<PaperPicture> pictures, boolean finished) {
        return new PaperReport(machine, plan, scene, measurements, failures, pictures, finished);
    }

    private void drawReferences() {
        try (Engine engine = opener.apply(Benchmark.REFERENCE)) {
            for (PaperSetting setting : plan.settings()) {
                progress.begins("reference", setting.size(), 1);
                Frame frame =
                        Frame.ofPixels(setting.size().width(), setting.size().height());
                engine.render(inputAt(setting), frame);
                progress.drewFrame();
                references.put(setting, frame);
            }
        }
    }

    private void measure(String id) {
        EngineMeasuring measuring =
                new EngineMeasuring(plan.warmupFrames(), plan.frames(), plan.maxSeconds(), progress);
        try (Engine engine = opener.apply(id)) {
            AskedEngine asked = new AskedEngine(id, engine);
            letCompile(asked);
            for (PaperSetting setting : plan.settings()) {
                progress.begins(asked.id(), setting.size(), plan.framesEach());
                Measurement measurement = measuring.measure(
                        asked, inputAt(setting), references.get(setting).argb());
                measurements.add(measurement);
                progress.measured(measurement);
                soFar.accept(report(List.of(), false));
            }
        } catch (EngineException failure) {
            note(new EngineFailure(id, failure.getMessage()));
        } catch (OutOfMemoryError _) {
            note(new EngineFailure(id, EngineFailure.outOfMemory()));
        }
    }

    private void note(EngineFailure failure) {
        failures.add(failure);
        soFar.accept(report(List.of(), false));
    }

    private void letCompile(AskedEngine asked) {
        if (plan.warmupFrames() > 0) {
            List<FrameInput> inputs = plan.shown().stream().map(this::inputAt).toList();
            new EngineWarmUp(FIRST_WARM_UP_SETTINGS * plan.maxSeconds(), progress)
                    .run(asked, plan.sizes().getFirst(), inputs);
        }
    }

    private FrameInput inputAt(PaperSetting setting) {
        world.setSettings(world.settings()
                .withSize(setting.size().width(), setting.size().height())
                .withShadows(setting.shadowSamples())
                .withBounces(setting.bounces()));
        return world.snapshot();
    }
}
