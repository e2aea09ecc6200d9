package dev.twister.render;

import dev.twister.denoise.DenoiserOffer;
import dev.twister.engine.EngineOffer;
import dev.twister.image.PictureSize;
import dev.twister.scene.Scene;
import dev.twister.world.Picture;
import java.util.List;
import java.util.Optional;

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
        List<Picture> pictures,
        Sampling sampling,
        PicturePart part,
        Movement movement,
        Finishing finishing,
        RenderOutput output) {
    /** The same with a denoiser; stages and views without reflections are not denoised. */
    public RenderOrder denoisedBy(Optional<DenoiserOffer> denoiser) {
        Finishing denoised =
                new Finishing(finishing.autoExposure(), finishing.guides(), finishing.lightLayers(), denoiser);
        return new RenderOrder(scene, engine, pictures, sampling, part, movement, denoised, output);
    }

    /** The size of each picture. */
    public PictureSize size() {
        return new PictureSize(scene.rendering().width(), scene.rendering().height());
    }
}
