package dev.twister.gui.drawing;

import dev.twister.physics.Simulation;
import dev.twister.scene.Light;
import dev.twister.scene.Physics;
import dev.twister.scene.Plane;
import dev.twister.scene.Pour;
import dev.twister.scene.Scene;
import dev.twister.scene.Sphere;
import dev.twister.world.World;
import java.util.List;
import java.util.Optional;

/**
 * Lets a scene's bodies move as time passes between pictures. They start anew where a body, the physics or the pour was
 * edited. Used by the drawing thread alone.
 */
final class MovingBodies implements AutoCloseable {
    private static final double NANOS_PER_SECOND = 1e9;

    /** Where a picture takes longer, bodies move more slowly: else they would leave ever more steps to take. */
    private static final double LONGEST_SECONDS = 0.1;

    /** What the physics sees of a scene. */
    private record Cause(
            long start, List<Sphere> spheres, Light light, Plane plane, Physics physics, Optional<Pour> pour) {
        static Cause of(Scene scene, Motion motion) {
            return new Cause(
                    motion.start(), scene.spheres(), scene.light(), scene.plane(), scene.physics(), scene.pour());
        }
    }

    private Optional<Simulation> simulation = Optional.empty();
    private Optional<Cause> cause = Optional.empty();
    private Optional<World> placed = Optional.empty();
    private long steps;
    private long lastNanos;
    private boolean wasRunning;

    /** Lets the time pass that has passed, and puts the world's bodies where they are then. */
    void place(Scene scene, Motion motion, World world, long nanos) {
        if (!motion.isOn()) {
            close();
            return;
        }
        Cause wanted = Cause.of(scene, motion);
        boolean anew = cause.filter(wanted::equals).isEmpty();
        if (anew) {
            simulation.ifPresent(Simulation::close);
            simulation = Optional.of(Simulation.of(scene));
            // After an edit the steps that were asked for before it are taken.
            steps = cause.filter(old -> old.start() == motion.start()).isPresent() ? motion.steps() : 0;
            cause = Optional.of(wanted);
            wasRunning = false;
        }
        Simulation now = simulation.orElseThrow();
        boolean moved = anew || placed.filter(old -> old.equals(world)).isEmpty();
        if (motion.running() && wasRunning) {
            now.advance(Math.clamp((nanos - lastNanos) / NANOS_PER_SECOND, 0, LONGEST_SECONDS));
            moved = true;
        }
        for (; steps < motion.steps(); steps++) {
            now.step();
            moved = true;
        }
        lastNanos = nanos;
        wasRunning = motion.running();
        if (moved) {
            now.place(world);
            placed = Optional.of(world);
        }
    }

    /** Forgets the motion. */
    @Override
    public void close() {
        simulation.ifPresent(Simulation::close);
        simulation = Optional.empty();
        cause = Optional.empty();
        placed = Optional.empty();
    }
}
