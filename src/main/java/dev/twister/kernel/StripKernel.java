package dev.twister.kernel;

/**
 * {@link PixelKernel} for a {@link Strip} of pixels, with the same equations and shortcuts: for devices that are CPUs,
 * whose compilers find vector instructions in its loops and none in a pixel's way through the branches.
 */
public final class StripKernel {
    private StripKernel() {}

    /**
     * Draws the pixels from that column of that row of the band, {@link Strip#LANES} or as many as the row has left. The
     * arrays are {@link Layout}'s.
     *
     * @param firstColumn in [0, width)
     * @param row in [0, rows) of the band
     * @param argb {@code int[width * rows]} where the output is ARGB, else any
     * @param radiance {@code float[3 * width * rows]} where the output is LINEAR, else any
     * @param lanes {@link Strip#FLOATS} floats of this thread's own
     * @param marks {@link Strip#MARKS} ints of this thread's own
     * @param scratch {@link Layout#SCRATCH_LENGTH} floats of this thread's own
     * @param shortcuts {@link PixelKernel#SHORTCUTS} or {@link PixelKernel#FEW_SPHERES}
     * @param output one of {@link PixelKernel}'s
     */
    public static void draw(
            int firstColumn,
            int row,
            int[] argb,
            float[] radiance,
            int[] dimensions,
            float[] camera,
            float[] rayTracingProperties,
            float[] bodyPositions,
            float[] bodySizes,
            float[] bodyColors,
            float[] bodyReflectivities,
            float[] skybox,
            int[] skyboxDimensions,
            float[] shadowDisc,
            float[] pixelOffsets,
            float[] hierarchy,
            float[] lanes,
            int[] marks,
            float[] scratch,
            int shortcuts,
            int output) {
        int width = dimensions[Layout.WIDTH];
        int bodies = dimensions[Layout.BODIES];
        int root = Layout.root(bodies);
        int pixels = Math.min(Strip.LANES, width - firstColumn);
        int shadowSamples = (int) rayTracingProperties[Layout.SHADOW_SAMPLES];
        int bounceLimit = (int) rayTracingProperties[Layout.BOUNCES];
        int pixelSamples = (int) rayTracingProperties[Layout.PIXEL_SAMPLES];
        float ambient = rayTracingProperties[Layout.AMBIENT];
        float discRadius = 2f * bodySizes[Layout.LIGHT];
        for (int lane = 0; lane < pixels; lane++) {
            lanes[Strip.RED + lane] = 0f;
            lanes[Strip.GREEN + lane] = 0f;
            lanes[Strip.BLUE + lane] = 0f;
        }
        StripShadow.copyDisc(shadowSamples, shadowDisc, lanes);
        for (int sample = 0; sample < pixelSamples; sample++) {
            StripRays.begin(firstColumn, row, pixels, sample, dimensions, camera, pixelOffsets, lanes, marks);
            int going = pixels;
            for (int bounce = 0; bounce <= bounceLimit && going > 0; bounce++) {
                if (shortcuts == PixelKernel.FEW_SPHERES) {
                    StripHits.ofAllBodies(pixels, bodyPositions, bodySizes, bodies, lanes, marks);
                } else {
                    StripHits.ofHierarchy(pixels, bodyPositions, bodySizes, hierarchy, root, lanes, marks, scratch);
                }
                if (Strip.count(marks, pixels, Layout.NOTHING, Layout.NOTHING) > 0) {
                    StripSky.add(pixels, skybox, skyboxDimensions, lanes, marks);
                }
                if (Strip.count(marks, pixels, Layout.LIGHT, Layout.LIGHT) > 0) {
                    StripSky.addLight(pixels, bodyColors, lanes, marks);
                }
                going = Strip.count(marks, pixels, Layout.PLANE, bodies);
                if (going > 0) {
                    StripSurface.look(pixels, bodyPositions, bodySizes, bodyColors, bodyReflectivities, lanes, marks);
                    StripSurface.find(pixels, rayTracingProperties, bodyPositions, lanes, marks);
                    StripShadow.cone(pixels, discRadius, shadowSamples, shadowDisc, lanes);
                    if (shortcuts == PixelKernel.FEW_SPHERES) {
                        StripShadow.cull(pixels, hierarchy, root, lanes, marks);
                    }
                    StripShadow.find(pixels, shadowSamples, hierarchy, root, lanes, marks, scratch);
                    StripShading.power(pixels, lanes);
                    int last = bounce < bounceLimit ? 0 : 1;
                    going = StripShading.shade(pixels, ambient, last, bodyColors, lanes, marks);
                }
            }
        }
        int first = row * width + firstColumn;
        float average = 1f / pixelSamples;
        if (output == PixelKernel.LINEAR) {
            StripOutput.storeRadiance(first, pixels, average, lanes, radiance);
        } else {
            StripOutput.storePixels(first, pixels, average, rayTracingProperties, lanes, argb);
        }
    }
}
