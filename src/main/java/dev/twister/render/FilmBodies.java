package dev.twister.render;

import dev.twister.physics.Simulation;
import dev.twister.render.RenderOrder.BodyMotion;
import dev.twister.scene.Scene;
import dev.twister.scene.Vector3;
import dev.twister.world.Bodies;
import dev.twister.world.FrameInput;
import dev.twister.world.SceneMeshes;
import dev.twister.world.World;
import java.io.IOException;
import java.util.concurrent.atomic.AtomicInteger;

/** Moves the bodies of a world to their positions in the frames of a film. */
interface FilmBodies extends AutoCloseable {
    /**
     * Moves the bodies.
     *
     * @param frame at least that of the previous call
     * @throws IOException if the positions cannot be read
     */
    void place(World world, int frame) throws IOException;

    @Override
    default void close() {}

    static FilmBodies of(BodyMotion motion, Scene scene, SceneMeshes meshes, RenderProgress progress) {
        return switch (motion) {
            case BodyMotion.Still _ -> (_, _) -> {};
            case BodyMotion.Recorded recorded -> recorded.file()::place;
            case BodyMotion.Seen seen -> (world, _) -> placeAs(seen.picture(), world);
            case BodyMotion.Simulated simulated -> simulated(simulated, Simulation.of(scene, meshes), progress);
        };
    }

    private static FilmBodies simulated(BodyMotion.Simulated motion, Simulation simulation, RenderProgress progress) {
        try {
            int steps = Simulation.stepsIn(motion.startSeconds());
            AtomicInteger done = new AtomicInteger();
            simulation.advance(motion.startSeconds(), () -> progress.settling(done.incrementAndGet(), steps));
            return new FilmBodies() {
                private int simulated;

                @Override
                public void place(World world, int frame) {
                    while (simulated < frame) {
                        simulation.advance(motion.secondsPerFrame());
                        simulated++;
                        progress.moved();
                    }
                    simulation.place(world);
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
