package dev.twister.render;

import dev.twister.engine.EngineOffer;
import dev.twister.image.PictureSize;
import dev.twister.scene.Scene;
import dev.twister.world.StageOrView;
import java.util.List;

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

    /** The size of each picture. */
    public PictureSize size() {
        return new PictureSize(scene.rendering().width(), scene.rendering().height());
    }
}
