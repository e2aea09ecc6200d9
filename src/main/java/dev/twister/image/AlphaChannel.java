package dev.twister.image;

import dev.twister.image.ExrPicture.ExrChannel;
import java.util.Optional;

/**
 * The part of each pixel that bodies cover, in a picture without background. The linear colors of such a picture are
 * multiplied by it.
 *
 * @param values array with the values of all pixels, row by row from the top
 * @param first index of the first pixel's value
 * @param stride distance between the values of neighbors in a row, 1 or more
 */
@SuppressWarnings("ArrayRecordComponent") // never compared
public record AlphaChannel(float[] values, int first, int stride) {
    /** Its name in .exr files. */
    public static final String NAME = "A";

    private static final int CHANNELS = 3;
    private static final int SHIFT = 24;
    private static final int OPAQUE = 255;
    private static final int COLOR_MASK = 0xFFFFFF;

    /** Of a frame without background: its last layer. */
    public static AlphaChannel of(Frame frame) {
        return new AlphaChannel(frame.layers(), frame.firstOf(frame.layerCount() - 1), CHANNELS);
    }

    /** Of an .exr file, if it has one. */
    public static Optional<AlphaChannel> of(ExrPicture picture) {
        return picture.channels().stream()
                .filter(channel -> channel.name().equals(NAME))
                .findFirst()
                .map(channel -> new AlphaChannel(channel.values(), channel.first(), channel.stride()));
    }

    /** The channel of an .exr file. */
    public ExrChannel channel() {
        return new ExrChannel(NAME, values, first, stride);
    }

    /** Colors that are not multiplied by alpha; black where nothing is covered. */
    public float[] straight(float[] radiance) {
        float[] straight = new float[radiance.length];
        for (int i = 0; i < radiance.length; i++) {
            float alpha = at(i / CHANNELS);
            straight[i] = alpha > 0 ? radiance[i] / alpha : 0;
        }
        return straight;
    }

    /** Makes the colors black where nothing is covered, to where a denoiser may have spread light. */
    public void cut(float[] radiance) {
        for (int i = 0; i < radiance.length; i++) {
            radiance[i] = at(i / CHANNELS) > 0 ? radiance[i] : 0;
        }
    }

    /** Replaces the alpha of pixels. */
    public void put(int[] argb) {
        for (int pixel = 0; pixel < argb.length; pixel++) {
            int alpha = Math.clamp(Math.round(OPAQUE * at(pixel)), 0, OPAQUE);
            argb[pixel] = alpha << SHIFT | (argb[pixel] & COLOR_MASK);
        }
    }

    private float at(int pixel) {
        return values[first + stride * pixel];
    }
}
