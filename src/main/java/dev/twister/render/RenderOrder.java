package dev.twister.render;

import dev.twister.engine.EngineOffer;
import dev.twister.image.PictureSize;
import dev.twister.motion.MotionFile;
import dev.twister.scene.Scene;
import dev.twister.world.FrameInput;
import dev.twister.world.StageOrView;
import java.util.List;
import java.util.function.DoubleFunction;

/**
 * Everything that the files of a rendering depend on; {@link Renderer} carries it out.
 *
 * @param scene with the camera and the settings to render with
 * @param engine is opened for the first picture and closed after the last one
 * @param pictures the picture, a stage, or views; several need an .exr file
 * @param sampling samples of each pixel; replaces the scene's
 * @param part rows or samples to which the picture is limited
 */
public record RenderOrder(
        Scene scene,
        EngineOffer engine,
        List<StageOrView> pictures,
        Sampling sampling,
        PicturePart part,
        Movement movement,
        Finishing finishing,
        RenderOutput output) {
    /** The same with other samples and another finish; stages and views without reflections have no layers. */
    public RenderOrder with(Sampling otherSampling, Finishing otherFinish) {
        return new RenderOrder(scene, engine, pictures, otherSampling, part, movement, otherFinish, output);
    }

    /** The same over another background. */
    public RenderOrder over(Background background) {
        RenderOutput other = new RenderOutput(output.file(), output.frames(), output.existing(), background);
        return new RenderOrder(scene, engine, pictures, sampling, part, movement, finishing, other);
    }

    /** The size of each picture. */
    public PictureSize size() {
        return new PictureSize(scene.rendering().width(), scene.rendering().height());
    }

    /**
     * What changes between the frames of a film.
     *
     * @param scene of the order at a time in seconds; physics may move its spheres elsewhere
     * @param rate frames per second
     * @param shutter how long the shutter is open before a frame's time, as a fraction of a frame; 0 if nothing moves
     */
    public record Movement(BodyMotion bodies, DoubleFunction<Scene> scene, double rate, double shutter) {
        /** Whether moving things are blurred. */
        public boolean isBlurred() {
            return shutter > 0;
        }
    }

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
}
