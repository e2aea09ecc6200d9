package dev.twister.render;

import dev.twister.motion.MotionFile;
import dev.twister.world.FrameInput;

/** Where the bodies' positions in each frame come from. */
public sealed interface BodyMotion {
    /** The scene's positions in every frame. */
    record Still() implements BodyMotion {}

    /**
     * Simulated physics.
     *
     * @param startSeconds simulated time before frame 0
     * @param secondsPerFrame simulated time between frames
     */
    record Simulated(double startSeconds, double secondsPerFrame) implements BodyMotion {}

    /** Read by frame number; the file stays open until the rendering ends, and is closed by its opener. */
    record Recorded(MotionFile file) implements BodyMotion {}

    /** The positions of a picture of the same scene, in every frame. */
    record Seen(FrameInput picture) implements BodyMotion {}
}
