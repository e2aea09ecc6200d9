package dev.twister.bench;

import dev.twister.engine.Engine;
import dev.twister.image.Frame;
import dev.twister.image.FrameTimes;
import dev.twister.image.PictureSize;
import dev.twister.physics.Simulation;
import dev.twister.world.FrameInput;
import dev.twister.world.World;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Function;

/** Measures an engine while bodies move: each frame's step, rebuild and drawing apart. */
final class MotionMeasuring {
    private static final double NANOS_PER_MILLI = 1e6;
    private static final double NANOS_PER_SECOND = 1e9;

    private final BenchmarkPlan plan;
    private final MotionPlan motion;
    private final World world;
    private final BenchmarkProgress progress;
    private final List<FrameTimes> times = new ArrayList<>();
    private long stepNanos;
    private long rebuildNanos;
    private FrameInput input;

    /** The world's settings must be those to measure with. */
    MotionMeasuring(BenchmarkPlan plan, MotionPlan motion, World world, BenchmarkProgress progress) {
        this.plan = plan;
        this.motion = motion;
        this.world = world;
        this.progress = progress;
        input = world.snapshot();
    }

    /**
     * Draws warm-up frames of the scene at its start, and moves it from there with the measured ones: the same frames for
     * every engine, however many it draws to warm up.
     *
     * @param warmUp what the engine draws of the world as it is at the start: before that it may be without most bodies, and
     *     the code that their frames take would not be compiled
     * @param reference draws what the last frame should have been
     */
    Measurement measure(AskedEngine asked, Consumer<FrameInput> warmUp, Function<FrameInput, int[]> reference) {
        PictureSize size = new PictureSize(input.width(), input.height());
        Frame frame = Frame.ofPixels(input.width(), input.height());
        int warmups;
        try (Simulation simulation = Simulation.of(motion.scene())) {
            moveToStart(simulation, asked.id(), size);
            simulation.place(world);
            warmUp.accept(world.snapshot());
            progress.begins(asked.id(), size, plan.warmupFrames() + plan.frames());
            long start = System.nanoTime();
            warmups = warmUp(asked.engine(), simulation, frame, start);
            // An engine that left pixels unwritten would show the warm-up's: what is compared is drawn over nothing.
            Arrays.fill(frame.argb(), 0);
            while (times.size() < plan.frames() && (times.isEmpty() || isWithin(start, plan.maxSeconds()))) {
                draw(asked.engine(), simulation, frame);
            }
        }
        MeasuredFrames measured = new MeasuredFrames(times);
        double frames = times.size() * NANOS_PER_MILLI;
        return new Measurement(
                asked.id(),
                asked.device(),
                size,
                input.shadowSamples(),
                input.bounces(),
                input.bodyCount(),
                warmups,
                measured.statistics(),
                measured.deviceTimes(),
                PictureComparison.of(reference.apply(input), frame.argb()),
                Optional.of(new MotionTimes(stepNanos / frames, rebuildNanos / frames, measured.millis())));
    }

    private void moveToStart(Simulation simulation, String engine, PictureSize size) {
        int steps = Simulation.stepsIn(motion.startSeconds());
        if (steps > 0) {
            progress.begins(engine + ", moving to its start,", size, steps);
            simulation.advance(motion.startSeconds(), progress::drewFrame);
        }
    }

    private int warmUp(Engine engine, Simulation simulation, Frame frame, long start) {
        int drawn = 0;
        // Steps are to be compiled too, but the bodies that are measured must stay at their start.
        try (Simulation rehearsal = Simulation.of(motion.scene())) {
            while (drawn < plan.warmupFrames() && (drawn == 0 || isWithin(start, plan.maxSeconds() / 2))) {
                rehearsal.advance(motion.secondsPerFrame());
                simulation.place(world);
                engine.render(world.snapshot(), frame);
                progress.drewFrame();
                drawn++;
            }
        }
        return drawn;
    }

    private void draw(Engine engine, Simulation simulation, Frame frame) {
        long start = System.nanoTime();
        simulation.advance(motion.secondsPerFrame());
        long stepped = System.nanoTime();
        simulation.place(world);
        input = world.snapshot();
        rebuildNanos += System.nanoTime() - stepped;
        stepNanos += stepped - start;
        engine.render(input, frame);
        times.add(frame.times());
        progress.drewFrame();
    }

    private static boolean isWithin(long start, double seconds) {
        return (System.nanoTime() - start) / NANOS_PER_SECOND < seconds;
    }
}
