package dev.twister.render;

import dev.twister.motion.MotionFile;
import dev.twister.motion.MotionFrame;
import dev.twister.physics.Simulation;
import dev.twister.render.RenderOrder.BodyMotion;
import dev.twister.render.RenderOrder.Movement;
import dev.twister.scene.Scene;
import dev.twister.scene.Vector3;
import dev.twister.world.Bodies;
import dev.twister.world.FrameInput;
import dev.twister.world.SceneMeshes;
import dev.twister.world.World;
import java.io.IOException;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicInteger;

/** Moves the bodies of a world to their positions in the frames of a film, and on their way from frame to frame. */
interface FilmBodies extends AutoCloseable {
    /** Before the first frame. */
    MotionFrame NOWHERE = new MotionFrame(0, new float[0]);

    /**
     * Goes on to a frame.
     *
     * @param frame at least that of the previous call
     * @throws IOException if the positions cannot be read
     */
    default void advance(int frame) throws IOException {}

    /**
     * Moves the bodies to their positions in the frame, or on the straight way there from the frame before.
     *
     * @param share of the way, in [0, 1]; 1 is the frame itself
     */
    void place(World world, double share);

    @Override
    default void close() {}

    static FilmBodies of(Movement movement, Scene scene, SceneMeshes meshes, RenderProgress progress) {
        return switch (movement.bodies()) {
            case BodyMotion.Still _ -> (_, _) -> {};
            case BodyMotion.Recorded(MotionFile file) -> recorded(file, movement.isBlurred());
            case BodyMotion.Seen seen -> (world, _) -> placeAs(seen.picture(), world);
            case BodyMotion.Simulated simulated ->
                simulated(
                        simulated,
                        Simulation.ofFilm(scene, meshes, simulated.startSeconds()),
                        movement.isBlurred() ? Optional.of(World.originOf(scene)) : Optional.empty(),
                        progress);
        };
    }

    /** The bodies rest before the file's first frame. */
    private static FilmBodies recorded(MotionFile file, boolean blurred) {
        return new FilmBodies() {
            private MotionFrame before = NOWHERE;
            private MotionFrame now = NOWHERE;

            @Override
            public void advance(int frame) throws IOException {
                now = file.frame(frame);
                before = blurred && frame > file.firstFrame() ? file.frame(frame - 1) : now;
            }

            @Override
            public void place(World world, double share) {
                now.place(world, before, share, file.origin());
            }
        };
    }

    /**
     * The bodies rest before the simulation's start.
     *
     * @param blurred the origin of the positions between frames; empty if they are not needed
     */
    private static FilmBodies simulated(
            BodyMotion.Simulated motion, Simulation simulation, Optional<Vector3> blurred, RenderProgress progress) {
        try {
            int steps = Simulation.stepsIn(motion.startSeconds());
            AtomicInteger done = new AtomicInteger();
            double last = blurred.isPresent() ? Math.min(motion.secondsPerFrame(), motion.startSeconds()) : 0;
            simulation.advance(motion.startSeconds() - last, () -> progress.settling(done.incrementAndGet(), steps));
            return new FilmBodies() {
                private Optional<MotionFrame> before = now();
                private int simulated;

                {
                    simulation.advance(last);
                }

                private Optional<MotionFrame> now() {
                    return blurred.map(origin -> new MotionFrame(simulation.bodies(), simulation.positions(origin)));
                }

                @Override
                public void advance(int frame) {
                    while (simulated < frame) {
                        before = simulated == frame - 1 ? now() : before;
                        simulation.advance(motion.secondsPerFrame());
                        simulated++;
                        progress.moved();
                    }
                }

                @Override
                public void place(World world, double share) {
                    if (share == 1) {
                        simulation.place(world);
                    } else {
                        now().orElseThrow().place(world, before.orElseThrow(), share, blurred.orElseThrow());
                    }
                }

                @Override
                public void close() {
                    simulation.close();
                }
            };
        } catch (RuntimeException | Error failure) {
            simulation.close();
            throw failure;
        }
    }

    /** Moves the bodies of a world to where they are in a picture of a scene with the same spheres. */
    private static void placeAs(FrameInput seen, World world) {
        Bodies bodies = seen.bodies();
        Vector3 from = bodies.origin();
        Vector3 to = world.origin();
        double[] shift = {from.x() - to.x(), from.y() - to.y(), from.z() - to.z()};
        float[] positions = new float[shift.length * bodies.room()];
        for (int i = 0; i < positions.length; i++) {
            int axis = i % shift.length;
            positions[i] = (float) (bodies.center(i / shift.length, axis) + shift[axis]);
        }
        world.setBodyPositions(positions, seen.bodyCount());
    }
}
