package dev.twister.gui.drawing;

import dev.twister.gui.drawing.DrawingRequest.Motion;
import dev.twister.physics.Simulation;
import dev.twister.scene.Scene;
import dev.twister.world.World;
import java.util.Optional;

/**
 * Moves a scene's bodies by the time between pictures. After an edit they go on as {@link Simulation#goOnIn} says. Used
 * only by the drawing thread.
 */
final class MovingBodies implements AutoCloseable {
    private static final double NANOS_PER_SECOND = 1e9;

    /** If a picture takes longer, bodies move more slowly; otherwise the steps to compute would grow without end. */
    private static final double LONGEST_SECONDS = 0.1;

    private Optional<Simulation> simulation = Optional.empty();
    private Optional<Scene> seen = Optional.empty();
    private long start = Motion.NONE.start();
    private long steps;
    private long lastNanos;
    private boolean wasRunning;

    /** Simulates the time that has passed, and updates the places of the world's bodies. */
    void place(Scene wanted, Motion motion, World world, long nanos) {
        if (!motion.isOn()) {
            close();
            return;
        }
        Scene scene = world.meshes().shown(wanted);
        boolean moved = !world.isMoved();
        if (start != motion.start()) {
            simulation.ifPresent(Simulation::close);
            simulation = Optional.of(Simulation.of(scene, world.meshes()));
            moved = true;
            start = motion.start();
            steps = 0;
            wasRunning = false;
        } else if (!seen.equals(Optional.of(scene))) {
            simulation = simulation.map(old -> old.goOnIn(scene, world.meshes()));
            moved = true;
        }
        seen = Optional.of(scene);
        Simulation now = simulation.orElseThrow();
        if (motion.running() && wasRunning) {
            now.advance(Math.clamp((nanos - lastNanos) / NANOS_PER_SECOND, 0, LONGEST_SECONDS));
            moved = true;
        }
        for (; steps < motion.steps(); steps++) {
            now.stepOnce();
            moved = true;
        }
        lastNanos = nanos;
        wasRunning = motion.running();
        if (moved) {
            now.place(world);
        }
    }

    /** Ends the motion. */
    @Override
    public void close() {
        simulation.ifPresent(Simulation::close);
        simulation = Optional.empty();
        seen = Optional.empty();
        start = Motion.NONE.start();
    }
}
