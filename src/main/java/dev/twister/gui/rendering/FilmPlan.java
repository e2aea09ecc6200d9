package dev.twister.gui.rendering;

import dev.twister.render.BodyMotion;
import dev.twister.render.FrameRange;
import dev.twister.render.Movement;
import dev.twister.scene.Scene;
import dev.twister.world.Animation;

/**
 * A film that the window renders.
 *
 * @param rate frames per second
 */
public record FilmPlan(FilmMotion motion, double rate, FrameRange frames) {
    /** What moves in the film of a scene. */
    Movement movement(Scene scene) {
        // As the command computes it, so that times agree to the last bit.
        double secondsPerFrame = 1 / rate;
        return new Movement(
                motion.movesBodies() ? new BodyMotion.Simulated(0, secondsPerFrame) : new BodyMotion.Still(),
                motion.followsKeyframes() ? seconds -> Animation.at(scene, seconds) : _ -> scene,
                1 / secondsPerFrame);
    }
}
