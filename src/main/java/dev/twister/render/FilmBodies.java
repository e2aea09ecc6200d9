package dev.twister.render;

import dev.twister.motion.MotionFile;
import dev.twister.physics.Simulation;
import dev.twister.world.World;
import java.io.IOException;

/** Where bodies are in the frames of a film. */
public interface FilmBodies {
    /**
     * Moves a world's bodies to where they are in a frame.
     *
     * @param frame its number, at least that of the call before
     * @throws IOException where that cannot be read
     */
    void place(World world, int frame) throws IOException;

    /** They stand where the scene has them. */
    static FilmBodies still() {
        return (_, _) -> {};
    }

    /**
     * They are simulated from frame to frame.
     *
     * @param eachFrame called after each of them, also of those that are not asked for; what it throws ends it
     */
    static FilmBodies simulated(Simulation simulation, double secondsPerFrame, Runnable eachFrame) {
        return new FilmBodies() {
            private int simulated;

            @Override
            public void place(World world, int frame) {
                while (simulated < frame) {
                    simulation.advance(secondsPerFrame);
                    simulated++;
                    eachFrame.run();
                }
                simulation.place(world);
            }
        };
    }

    /** They are where a motion file has them. */
    static FilmBodies recorded(MotionFile motion) {
        return motion::place;
    }
}
