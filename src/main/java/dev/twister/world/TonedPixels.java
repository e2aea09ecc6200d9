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
        int[] argb = new int[radiance.length / CHANNELS];
        write(radiance, frame, argb);
        return argb;
    }

    /**
     * Writes pixels as 0xAARRGGBB.
     *
     * @param radiance three floats per pixel: linear red, green and blue
     * @param input exposure, tone map and transfer function
     */
    public static void write(float[] radiance, FrameInput input, int[] argb) {
        write(radiance, input.view().frame(), argb);
    }

    private static void write(float[] radiance, float[] frame, int[] argb) {
        float[] path = new float[Layout.PATH_LENGTH];
        for (int pixel = 0; pixel < argb.length; pixel++) {
            System.arraycopy(radiance, CHANNELS * pixel, path, Layout.RADIANCE, CHANNELS);
            argb[pixel] = Tone.argb(path, 1, frame);
        }
    }
}
