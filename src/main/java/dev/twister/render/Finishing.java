package dev.twister.render;

import dev.twister.denoise.DenoiserOffer;
import dev.twister.kernel.Guides;
import dev.twister.kernel.Layout;
import dev.twister.world.StageOrView;
import java.util.Optional;

/**
 * What is done beside rendering samples.
 *
 * @param autoExposure whether the first picture of the film sets the exposure; no effect on linear files
 * @param guides whether an .exr file gets the guides of denoising as layers
 * @param lightLayers whether it gets them, and the light of each group of lights
 * @param denoiser removes the noise of the full picture; an .exr file then has the noisy picture and the guides as
 *     layers
 */
public record Finishing(boolean autoExposure, boolean guides, boolean lightLayers, Optional<DenoiserOffer> denoiser) {
    /** Nothing. */
    public static final Finishing NONE = new Finishing(false, false, false, Optional.empty());

    /** Whether a picture is rendered with guides. */
    boolean guides(StageOrView picture) {
        return isFull(picture) && (guides || lightLayers || denoiser.isPresent());
    }

    /** Whether a picture has light over all its bounces, which can be denoised. */
    public static boolean isFull(StageOrView picture) {
        return picture == StageOrView.BEAUTY;
    }

    /** For metadata of files. */
    String text() {
        return (guides ? " guides" : "")
                + (lightLayers ? " light-layers" : "")
                + (denoiser.isPresent() ? " denoised" : "");
    }

    /** Memory for layers and denoising, in bytes per pixel. */
    long bytesPerPixel() {
        long guided = guides || lightLayers || denoiser.isPresent() ? Guides.LAYERS : 0;
        long lights = lightLayers ? Layout.MOST_LIGHT_LAYERS : 0;
        return (guided + lights + (denoiser.isPresent() ? 2 : 0)) * BandedDrawing.bytesPerPixel(true);
    }
}
