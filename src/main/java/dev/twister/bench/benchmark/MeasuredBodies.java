package dev.twister.bench.benchmark;

import dev.twister.bench.benchmark.Measurement.MotionTimes;
import dev.twister.physics.Simulation;
import dev.twister.world.FrameInput;
import dev.twister.world.World;
import java.util.List;
import java.util.Optional;

/** The bodies of one measurement, at rest or moving with each frame. */
final class MeasuredBodies implements AutoCloseable {
    private static final double NANOS_PER_MILLI = 1e6;

    private final World world;
    private final Optional<Moving> moving;
    private FrameInput input;
    private long stepNanos;
    private long rebuildNanos;

    /**
     * A second simulation compiles the code for steps during warm-up, while the measured bodies stay at their start.
     */
    private record Moving(MotionPlan plan, Simulation simulation, Simulation rehearsal) {}

    /** For a world with the settings to measure. */
    MeasuredBodies(World world, Optional<MotionPlan> motion) {
        this.world = world;
        moving = motion.map(plan -> new Moving(
                plan, Simulation.of(plan.scene(), world.meshes()), Simulation.of(plan.scene(), world.meshes())));
        input = world.snapshot();
    }

    /** Number of steps to the start. */
    int stepsToStart() {
        return moving.map(bodies -> Simulation.stepsIn(bodies.plan().startSeconds()))
                .orElse(0);
    }

    /** Moves the bodies to their start. */
    void moveToStart(Runnable stepped) {
        moving.ifPresent(bodies -> {
            bodies.simulation().advance(bodies.plan().startSeconds(), stepped);
            place(bodies);
        });
    }

    /** The input of the last frame, or of the first one. */
    FrameInput input() {
        return input;
    }

    /** The input with the bodies at rest, after the work of a step in the second simulation. */
    FrameInput rehearse() {
        moving.ifPresent(bodies -> {
            bodies.rehearsal().advance(bodies.plan().secondsPerFrame());
            place(bodies);
        });
        return input;
    }

    /** The input with the bodies one frame later. */
    FrameInput next() {
        moving.ifPresent(bodies -> {
            long start = System.nanoTime();
            bodies.simulation().advance(bodies.plan().secondsPerFrame());
            long stepped = System.nanoTime();
            place(bodies);
            rebuildNanos += System.nanoTime() - stepped;
            stepNanos += stepped - start;
        });
        return input;
    }

    private void place(Moving bodies) {
        bodies.simulation().place(world);
        input = world.snapshot();
    }

    /** The costs of moving per frame, if bodies move. */
    Optional<MotionTimes> times(List<Double> drawing) {
        double frames = drawing.size() * NANOS_PER_MILLI;
        return moving.map(_ -> new MotionTimes(stepNanos / frames, rebuildNanos / frames, drawing));
    }

    @Override
    public void close() {
        moving.ifPresent(bodies -> {
            bodies.simulation().close();
            bodies.rehearsal().close();
        });
    }
}
