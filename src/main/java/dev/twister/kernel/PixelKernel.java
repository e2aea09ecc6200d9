package dev.twister.kernel;

/** Renders one pixel, from its view rays to the stored value. Engines call this kernel; it defines the picture. */
public final class PixelKernel {
    private PixelKernel() {}

    /**
     * Sums a pixel's samples in {@link Layout#RADIANCE}. {@link Layout} describes the arrays.
     *
     * @param column in [0, width)
     * @param row row of the band, in [0, rows)
     * @param path {@link Layout#PATH_LENGTH} floats, not shared between threads; {@link Layout#PLAIN_PATH_LENGTH} for
     *     plain materials and one light without meshes and counts
     * @param scratch {@link Layout#SCRATCH_LENGTH} floats, not shared between threads;
     *     {@link Layout#PLAIN_SCRATCH_LENGTH} for plain materials without meshes; {@link Layout#LAYERED_SCRATCH_LENGTH}
     *     with {@link LightLayers}
     * @param variant bits of {@link Variant}
     */
    public static void draw(
            int column,
            int row,
            float[] path,
            float[] scratch,
            float[] frame,
            float[] bodies,
            float[] looks,
            float[] meshes,
            float[] images,
            int variant) {
        int samples = isWanted(column, row, frame) != 0 ? (int) frame[Layout.PIXEL_SAMPLES] : 0;
        path[Layout.RADIANCE] = 0f;
        path[Layout.RADIANCE + 1] = 0f;
        path[Layout.RADIANCE + 2] = 0f;
        Views.start(path, variant);
        Guides.start(path, variant);
        Coverage.start(path, variant);
        LightLayers.start(scratch, frame, variant);
        for (int sample = 0; sample < samples; sample++) {
            start(path, column, row, sample, frame);
            Medium.begin(path, frame, variant);
            Guides.begin(path, variant);
            Coverage.begin(path, variant);
            add(path, scratch, frame, bodies, looks, meshes, images, variant);
        }
        Views.finish(path, variant);
    }

    /** 1 if the pixel's tile is to be rendered, else 0. */
    private static int isWanted(int column, int row, float[] frame) {
        int wanted = 1;
        int tiles = (int) frame[Layout.TILES];
        if (tiles > 0) {
            int across = ((int) frame[Layout.WIDTH] + Layout.TILE_SIDE - 1) / Layout.TILE_SIDE;
            int tile = row / Layout.TILE_SIDE * across + column / Layout.TILE_SIDE;
            wanted = frame[tiles + tile] > 0f ? 1 : 0;
        }
        return wanted;
    }

    /**
     * Stores the mean of a pixel's samples.
     *
     * @param pixels {@code int[width * rows]} if the output is ARGB, else any array
     * @param radiance {@code float[3 * width * rows]} if the output is linear, else any array
     * @param layers planes of {@code 3 * width * rows} floats for further layers if there are any, else any array
     * @param path after {@link #draw}
     * @param scratch after {@link #draw}
     */
    public static void store(
            int column,
            int row,
            int[] pixels,
            float[] radiance,
            float[] layers,
            float[] path,
            float[] scratch,
            float[] frame,
            int variant) {
        int pixel = row * (int) frame[Layout.WIDTH] + column;
        if ((variant & Variant.LINEAR) != 0) {
            float average = average(frame);
            radiance[3 * pixel] = path[Layout.RADIANCE] * average;
            radiance[3 * pixel + 1] = path[Layout.RADIANCE + 1] * average;
            radiance[3 * pixel + 2] = path[Layout.RADIANCE + 2] * average;
            storeLayers(pixel, layers, path, scratch, frame, variant);
        } else {
            pixels[pixel] = argb(path, frame);
        }
    }

    /** The 8-bit value of a pixel, after {@link #draw}. */
    public static int argb(float[] path, float[] frame) {
        return Tone.argb(path, average(frame), frame);
    }

    /** Factor of the sums in {@code path} for the mean of a pixel's samples. */
    public static float average(float[] frame) {
        return 1f / (int) frame[Layout.PIXEL_SAMPLES];
    }

    /** Stores a pixel's layers, as {@link #store} does. */
    public static void storeLayers(
            int pixel, float[] layers, float[] path, float[] scratch, float[] frame, int variant) {
        int plane = 3 * (int) frame[Layout.WIDTH] * (int) frame[Layout.ROWS];
        float average = average(frame);
        Guides.store(layers, 3 * pixel, plane, path, average, variant);
        LightLayers.store(layers, 3 * pixel + Guides.LAYERS * plane, plane, scratch, average, frame, variant);
        int guides = Views.isGuided(variant) != 0 ? Guides.LAYERS : 0;
        int lights = Views.isLayered(variant) != 0 ? (int) frame[Layout.LIGHT_LAYERS] : 0;
        Coverage.store(layers, 3 * pixel + (guides + lights) * plane, path, frame, variant);
    }

    /** Starts a sample's view ray. */
    public static void start(float[] path, int column, int row, int sample, float[] frame) {
        int at = (int) frame[Layout.SAMPLES] + Layout.SAMPLE_STRIDE * sample;
        float x = column + frame[at];
        float y = (int) frame[Layout.FIRST_ROW] + row + frame[at + 1];
        CameraRay.start(path, x, y, frame);
        path[Layout.PIXEL_COLUMN] = column;
        path[Layout.PIXEL_ROW] = (int) frame[Layout.FIRST_ROW] + row;
        path[Layout.PIXEL_SAMPLE] = at;
        if (frame[Layout.CAMERA_APERTURE] > 0f) {
            Lens.bend(path, frame);
        }
    }

    /** Adds the value of the path's view ray, from the whole path or from the first hit. */
    private static void add(
            float[] path,
            float[] scratch,
            float[] frame,
            float[] bodies,
            float[] looks,
            float[] meshes,
            float[] images,
            int variant) {
        if (Views.endsAtFirstHit(variant) != 0) {
            FirstHit.add(path, scratch, frame, bodies, looks, meshes, images, variant);
        } else if ((variant & Variant.PATH) != 0) {
            PathTracer.follow(path, scratch, frame, bodies, looks, meshes, images, variant);
        } else {
            Path.follow(path, scratch, frame, bodies, looks, meshes, images, variant);
        }
    }
}
