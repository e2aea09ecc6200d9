package dev.twister.render;

import dev.twister.engine.NumberColors;
import dev.twister.image.ExrPicture.ExrChannel;
import dev.twister.image.Frame;
import dev.twister.world.StageOrView;
import java.util.ArrayList;
import java.util.List;

/**
 * A rendered picture, stage or view.
 *
 * @param drawn its frame is linear if the output is, or if the values are not colors
 * @param layers further channels of an .exr file: guides of denoising, and the noisy picture
 */
public record RenderedView(StageOrView picture, BandedDrawing.Drawn drawn, List<ExrChannel> layers) {
    private static final String COLOR_CHANNELS = "RGB";
    private static final int CHANNELS = 3;

    /** Holds pixels or radiance. */
    public Frame frame() {
        return drawn.frame();
    }

    /** 0xAARRGGBB of each pixel, row by row from the top. */
    public int[] pixels() {
        return picture.isColor() ? frame().argb() : NumberColors.pixels(picture, frame().radiance());
    }

    /**
     * The channels in a file: red, green and blue, or one for numbers, in a layer with the picture's name.
     *
     * @param alone whether the file has no other picture; then, and for beauty, there is no layer
     */
    List<ExrChannel> channels(boolean alone) {
        String layer = alone || picture == StageOrView.BEAUTY ? "" : picture.id() + ".";
        if (picture.isNumber()) {
            // Compositors know Z as a layer's depth; plain readers know Y alone as gray.
            String channel = picture == StageOrView.DEPTH && !alone ? "Z" : "Y";
            return List.of(new ExrChannel(layer + channel, frame().radiance(), 0, CHANNELS));
        }
        List<ExrChannel> channels = new ArrayList<>();
        for (int channel = 0; channel < CHANNELS; channel++) {
            channels.add(new ExrChannel(layer + COLOR_CHANNELS.charAt(channel), frame().radiance(), channel, CHANNELS));
        }
        channels.addAll(layers);
        return channels;
    }
}
