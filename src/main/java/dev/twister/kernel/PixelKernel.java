package dev.twister.kernel;

/** One pixel, from its view rays to what is stored: the kernel that engines call, and that defines the picture. */
public final class PixelKernel {
    /** Values of the argument {@code output}: 8-bit ARGB into {@code pixels}, or linear floats into {@code radiance}. */
    public static final int ARGB = 0;

    public static final int LINEAR = 1;

    private PixelKernel() {}

    /**
     * Draws the pixel in that column of that row of the band. The arrays are {@link Layout}'s.
     *
     * @param column in [0, width)
     * @param row in [0, rows) of the band
     * @param pixels {@code int[width * rows]} where the output is ARGB, else any
     * @param radiance {@code float[3 * width * rows]} where the output is LINEAR, else any
     * @param path {@link Layout#PATH_LENGTH} floats of this thread's own
     * @param scratch {@link Layout#SCRATCH_LENGTH} floats of this thread's own
     * @param search {@link Hit#ALL} or {@link Hit#WALK}
     * @param output {@link #ARGB} or {@link #LINEAR}
     */
    public static void draw(
            int column,
            int row,
            int[] pixels,
            float[] radiance,
            int[] dimensions,
            float[] camera,
            float[] properties,
            float[] places,
            float[] looks,
            float[] hierarchy,
            float[] sky,
            int[] skyDimensions,
            float[] shadowDisc,
            float[] pixelOffsets,
            float[] path,
            float[] scratch,
            int search,
            int output) {
        int samples = (int) properties[Layout.PIXEL_SAMPLES];
        path[Layout.RADIANCE] = 0f;
        path[Layout.RADIANCE + 1] = 0f;
        path[Layout.RADIANCE + 2] = 0f;
        for (int sample = 0; sample < samples; sample++) {
            float x = column + pixelOffsets[2 * sample];
            float y = dimensions[Layout.FIRST_ROW] + row + pixelOffsets[2 * sample + 1];
            Camera.start(path, x, y, dimensions, camera);
            Path.follow(
                    path,
                    0,
                    properties,
                    places,
                    looks,
                    hierarchy,
                    dimensions[Layout.BODIES],
                    sky,
                    skyDimensions,
                    shadowDisc,
                    scratch,
                    search);
        }
        int pixel = row * dimensions[Layout.WIDTH] + column;
        float average = 1f / samples;
        if (output == LINEAR) {
            radiance[3 * pixel] = path[Layout.RADIANCE] * average;
            radiance[3 * pixel + 1] = path[Layout.RADIANCE + 1] * average;
            radiance[3 * pixel + 2] = path[Layout.RADIANCE + 2] * average;
        } else {
            pixels[pixel] = Tone.argb(path, average, properties);
        }
    }
}
