package dev.twister.kernel;

/** Stores a strip's pixels. */
final class StripOutput {
    private StripOutput() {}

    /** The samples' average as linear floats. */
    static void storeRadiance(int first, int pixels, float average, float[] lanes, float[] radiance) {
        for (int lane = 0; lane < pixels; lane++) {
            radiance[3 * (first + lane)] = lanes[Strip.RED + lane] * average;
            radiance[3 * (first + lane) + 1] = lanes[Strip.GREEN + lane] * average;
            radiance[3 * (first + lane) + 2] = lanes[Strip.BLUE + lane] * average;
        }
    }

    /** The samples' average, tone mapped, as 8-bit ARGB. */
    static void storePixels(
            int first, int pixels, float average, float[] rayTracingProperties, float[] lanes, int[] argb) {
        float scale = rayTracingProperties[Layout.EXPOSURE_SCALE];
        int toneMap = (int) rayTracingProperties[Layout.TONE_MAP];
        float srgb = rayTracingProperties[Layout.SRGB];
        for (int lane = 0; lane < pixels; lane++) {
            int red = ToneMapping.quantized(lanes[Strip.RED + lane] * average, scale, toneMap, srgb);
            int green = ToneMapping.quantized(lanes[Strip.GREEN + lane] * average, scale, toneMap, srgb);
            int blue = ToneMapping.quantized(lanes[Strip.BLUE + lane] * average, scale, toneMap, srgb);
            argb[first + lane] = PixelKernel.OPAQUE | (red << 16) | (green << 8) | blue;
        }
    }
}
