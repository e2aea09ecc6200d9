package dev.twister.bench.device;

import dev.twister.bench.benchmark.Benchmark;
import dev.twister.bench.benchmark.BenchmarkPlan;
import dev.twister.bench.benchmark.BenchmarkProgress;
import dev.twister.bench.benchmark.BenchmarkReport;
import dev.twister.bench.benchmark.EngineFailure;
import dev.twister.bench.benchmark.Measurement;
import dev.twister.bench.benchmark.PictureComparison;
import dev.twister.bench.device.CheckedEngine.CheckedPicture;
import dev.twister.engine.Engine;
import dev.twister.engine.EngineException;
import dev.twister.engine.EngineOffer;
import dev.twister.engine.Engines;
import dev.twister.image.Frame;
import dev.twister.image.PictureSize;
import dev.twister.scene.Rendering;
import dev.twister.world.FrameInput;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/** Compares engines' pictures of several scenes with the reference's, and measures each engine in one of them. */
public final class DeviceCheck {
    private static final double NANOS_PER_SECOND = 1e9;

    /** Per pixel. All engines have the same samples, so that more of them would show nothing else. */
    private static final int MOST_SAMPLES = 16;

    private final DeviceCheckPlan plan;
    private final CheckedScene timed;
    private final List<Reference> references = new ArrayList<>();

    /**
     * The reference picture of a scene. The input stays the same while the measurements change the world's settings.
     */
    private record Reference(String scene, FrameInput input, Frame picture) {}

    /**
     * Renders the reference pictures.
     *
     * @param scenes at least one
     * @param timed the scene for the measurements
     * @throws EngineException if the reference cannot be rendered
     */
    public DeviceCheck(DeviceCheckPlan plan, List<CheckedScene> scenes, CheckedScene timed) {
        this.plan = plan;
        this.timed = timed;
        try (Engine engine = Engines.open(BenchmarkPlan.REFERENCE)) {
            for (CheckedScene scene : scenes) {
                FrameInput input = input(scene, plan.pictureSize());
                references.add(new Reference(scene.name(), input, draw(engine, input)));
            }
        }
    }

    /** Checks an engine; if it fails, the result includes the reason. */
    public CheckedEngine check(EngineOffer offer, BenchmarkProgress progress) {
        Optional<Double> compileSeconds = Optional.empty();
        List<CheckedPicture> pictures = new ArrayList<>();
        Optional<BenchmarkReport> measured = Optional.empty();
        Optional<String> failure = Optional.empty();
        if (offer.works()) {
            try {
                compileSeconds = drawScenes(offer, pictures, progress);
                measured = Optional.of(measure(offer, progress));
                failure = measured.get().failures().stream()
                        .map(EngineFailure::message)
                        .findFirst();
            } catch (EngineException e) {
                failure = Optional.of(e.getMessage());
            } catch (OutOfMemoryError _) {
                failure = Optional.of(EngineFailure.outOfMemory());
            }
        }
        return new CheckedEngine(
                offer.id(),
                measured.flatMap(report -> report.measurements().stream().reduce((_, last) -> last))
                        .map(Measurement::device)
                        .orElse(offer.device()),
                offer.driver(),
                compileSeconds,
                pictures,
                measured,
                offer.obstacle(),
                failure);
    }

    /** Compares the scenes' pictures; returns the compile time of a device. */
    private Optional<Double> drawScenes(EngineOffer offer, List<CheckedPicture> pictures, BenchmarkProgress progress) {
        Optional<Double> compileSeconds = Optional.empty();
        try (Engine engine = offer.opener().get()) {
            if (Engines.isDevice(offer.id())) {
                FrameInput first = first().input();
                compileSeconds = Optional.of(secondsBeyond(draw(engine, first), draw(engine, first)));
            }
            for (Reference reference : references) {
                progress.begins(offer.id() + " " + reference.scene(), plan.pictureSize(), 1);
                Frame frame = draw(engine, reference.input());
                pictures.add(new CheckedPicture(
                        reference.scene(),
                        PictureComparison.of(reference.picture().argb(), frame.argb())));
                progress.drewFrame();
            }
        }
        return compileSeconds;
    }

    /** The kernel whose compile time is told: that of the timed scene, whatever other scenes there are. */
    private Reference first() {
        return references.stream()
                .filter(reference -> reference.scene().equals(timed.name()))
                .findFirst()
                .orElse(references.getFirst());
    }

    private static double secondsBeyond(Frame first, Frame second) {
        return Math.max(0, first.times().totalNanos() - second.times().totalNanos()) / NANOS_PER_SECOND;
    }

    private BenchmarkReport measure(EngineOffer offer, BenchmarkProgress progress) {
        return Benchmark.run(
                id -> id.equals(offer.id()) ? offer.opener().get() : Engines.open(id),
                plan.timed(offer.id()),
                timed.name(),
                timed.world(),
                Optional.empty(),
                progress);
    }

    private static FrameInput input(CheckedScene scene, PictureSize size) {
        Rendering settings = scene.world().settings();
        scene.world()
                .setSettings(settings.withSize(size.width(), size.height())
                        .withSamplesPerPixel(Math.min(settings.samplesPerPixel(), MOST_SAMPLES)));
        return scene.world().snapshot();
    }

    private static Frame draw(Engine engine, FrameInput input) {
        Frame frame = Frame.ofPixels(input.width(), input.height());
        engine.render(input, frame);
        return frame;
    }
}
