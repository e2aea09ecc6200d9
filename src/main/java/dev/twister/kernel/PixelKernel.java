package dev.twister.kernel;

/** Renders one pixel, from its view rays to the stored value. Engines call this kernel; it defines the picture. */
public final class PixelKernel {
    /** Values of the argument {@code output}: 8-bit ARGB to {@code pixels}, or linear floats to {@code radiance}. */
    public static final int ARGB = 0;

    public static final int LINEAR = 1;

    private PixelKernel() {}

    /**
     * Renders one pixel of the band. {@link Layout} describes the arrays.
     *
     * @param column in [0, width)
     * @param row row of the band, in [0, rows)
     * @param pixels {@code int[width * rows]} if the output is ARGB, else any array
     * @param radiance {@code float[3 * width * rows]} if the output is LINEAR, else any array
     * @param path {@link Layout#PATH_LENGTH} floats, not shared between threads; {@link Layout#PLAIN_PATH_LENGTH} for
     *     plain materials without meshes and counts
     * @param scratch {@link Layout#SCRATCH_LENGTH} floats, not shared between threads;
     *     {@link Layout#PLAIN_SCRATCH_LENGTH} for plain materials without meshes
     * @param search {@link Hit#ALL} or {@link Hit#WALK}
     * @param firstMesh the first mesh's body, or {@link Layout#NO_MESHES}
     * @param materials {@link Material#PLAIN} or {@link Material#ANY}
     * @param aspect a constant of {@link Aspect}
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
            float[] meshes,
            float[] sky,
            int[] skyDimensions,
            float[] shadowDisc,
            float[] pixelSamples,
            float[] path,
            float[] scratch,
            int search,
            int firstMesh,
            int materials,
            int aspect,
            int output) {
        int samples = (int) properties[Layout.PIXEL_SAMPLES];
        path[Layout.RADIANCE] = 0f;
        path[Layout.RADIANCE + 1] = 0f;
        path[Layout.RADIANCE + 2] = 0f;
        Aspect.start(path, aspect);
        for (int sample = 0; sample < samples; sample++) {
            start(path, column, row, sample, dimensions, camera, pixelSamples);
            add(
                    path,
                    properties,
                    places,
                    looks,
                    hierarchy,
                    meshes,
                    dimensions[Layout.BODIES],
                    sky,
                    skyDimensions,
                    shadowDisc,
                    pixelSamples,
                    scratch,
                    search,
                    firstMesh,
                    materials,
                    aspect);
        }
        Aspect.finish(path, aspect);
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

    /** Starts a sample's view ray. */
    public static void start(
            float[] path, int column, int row, int sample, int[] dimensions, float[] camera, float[] pixelSamples) {
        int at = Layout.SAMPLE_STRIDE * sample;
        float x = column + pixelSamples[at];
        float y = dimensions[Layout.FIRST_ROW] + row + pixelSamples[at + 1];
        Camera.start(path, x, y, dimensions, camera);
        path[Layout.PIXEL_COLUMN] = column;
        path[Layout.PIXEL_ROW] = dimensions[Layout.FIRST_ROW] + row;
        path[Layout.PIXEL_SAMPLE] = at;
        if (camera[Layout.CAMERA_APERTURE] > 0f) {
            Lens.bend(path, camera, pixelSamples);
        }
    }

    /** Adds the value of the path's view ray, from the whole path or from the first hit. */
    private static void add(
            float[] path,
            float[] properties,
            float[] places,
            float[] looks,
            float[] hierarchy,
            float[] meshes,
            int bodies,
            float[] sky,
            int[] skyDimensions,
            float[] shadowDisc,
            float[] pixelSamples,
            float[] scratch,
            int search,
            int firstMesh,
            int materials,
            int aspect) {
        if (Aspect.endsAtFirstHit(aspect) != 0) {
            FirstHit.add(
                    path,
                    properties,
                    places,
                    looks,
                    hierarchy,
                    meshes,
                    bodies,
                    sky,
                    skyDimensions,
                    shadowDisc,
                    scratch,
                    search,
                    firstMesh,
                    materials,
                    aspect);
        } else {
            Path.follow(
                    path,
                    0,
                    properties,
                    places,
                    looks,
                    hierarchy,
                    meshes,
                    bodies,
                    sky,
                    skyDimensions,
                    shadowDisc,
                    pixelSamples,
                    scratch,
                    search,
                    firstMesh,
                    materials,
                    aspect);
        }
    }
}
