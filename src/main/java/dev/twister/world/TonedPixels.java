package dev.twister.world;

import dev.twister.kernel.Layout;
import dev.twister.kernel.Tone;
import dev.twister.scene.RenderSettings;

/** Makes radiance that was kept into pixels, as the kernel does. */
public final class TonedPixels {
    private static final int CHANNELS = 3;

    private TonedPixels() {}

    /**
     * Pixels of 0xAARRGGBB.
     *
     * @param radiance three floats a pixel: linear red, green and blue
     * @param settings exposure, tone map and curve
     */
    public static int[] of(float[] radiance, RenderSettings settings) {
        float[] properties = new float[Layout.PROPERTIES_LENGTH];
        World.putTone(properties, settings);
        float[] path = new float[Layout.PATH_LENGTH];
        int[] argb = new int[radiance.length / CHANNELS];
        for (int pixel = 0; pixel < argb.length; pixel++) {
            System.arraycopy(radiance, CHANNELS * pixel, path, Layout.RADIANCE, CHANNELS);
            argb[pixel] = Tone.argb(path, 1, properties);
        }
        return argb;
    }
}
