package dev.twister.world;

import dev.twister.kernel.Layout;
import dev.twister.kernel.Tone;
import dev.twister.scene.Rendering;

/** Converts stored radiance to pixels, like the kernel. */
public final class TonedPixels {
    private static final int CHANNELS = 3;

    private TonedPixels() {}

    /**
     * Pixels as 0xAARRGGBB.
     *
     * @param radiance three floats per pixel: linear red, green and blue
     * @param settings exposure, tone map and transfer function
     */
    public static int[] of(float[] radiance, Rendering settings) {
        float[] frame = new float[Layout.SAMPLES];
        World.putTone(frame, settings);
        return of(radiance, frame);
    }

    /** As above, with the exposure, tone map and transfer function of an input. */
    public static int[] of(float[] radiance, FrameInput input) {
        return of(radiance, input.view().frame());
    }

    private static int[] of(float[] radiance, float[] frame) {
        float[] path = new float[Layout.PATH_LENGTH];
        int[] argb = new int[radiance.length / CHANNELS];
        for (int pixel = 0; pixel < argb.length; pixel++) {
            System.arraycopy(radiance, CHANNELS * pixel, path, Layout.RADIANCE, CHANNELS);
            argb[pixel] = Tone.argb(path, 1, frame);
        }
        return argb;
    }
}
