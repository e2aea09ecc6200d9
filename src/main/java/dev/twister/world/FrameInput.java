package dev.twister.world;

import dev.twister.kernel.Layout;
import java.util.Arrays;

/**
 * A snapshot of the world as the flat arrays that the kernel reads; {@link Layout} has the places in them.
 *
 * <p>The bodies' arrays have room for all that a scene may come to have; the first {@link #bodies} of them are there.
 *
 * <p>No array changes once it is in a snapshot: a world that moves on makes new ones and keeps those that still hold.
 * So an engine may know by the array's identity that what it holds (on a device, say) is still right.
 *
 * @param dimensions {@code int[5]}: width and height of the picture in pixels, first row and number of rows to draw, bodies that are there
 * @param camera {@code float[13]}: position, right, up, forward, eye distance
 * @param rayTracingProperties {@code float[10]}
 * @param bodyPositions {@code float[3 * room]}: centres; the plane's is (0, height, 0)
 * @param bodySizes {@code float[room]}: radii; the plane's side
 * @param bodyColors {@code float[3 * room]}: albedos; the light's radiance; the plane's first colour
 * @param bodyReflectivities {@code float[room]}: in [0, 128]
 * @param skybox {@code float[3 * width * height]}: linear radiance, row by row from the top
 * @param skyboxDimensions {@code int[2]}: width, height in texels
 * @param shadowDisc {@code float[2 * shadowSamples]}: the unit sunflower's points, {@code sqrt(i / n)} from the centre
 * @param pixelOffsets {@code float[2 * samplesPerPixel]}: the samples' places in a pixel, x and y in [0, 1)
 * @param hierarchy over the spheres that are there: see {@link SphereHierarchy}; its length depends on the room alone
 */
@SuppressWarnings("ArrayRecordComponent") // identity is what counts, see above
public record FrameInput(
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
        float[] hierarchy) {

    public int width() {
        return dimensions[Layout.WIDTH];
    }

    public int height() {
        return dimensions[Layout.HEIGHT];
    }

    public int firstRow() {
        return dimensions[Layout.FIRST_ROW];
    }

    public int rows() {
        return dimensions[Layout.ROWS];
    }

    /** Light, plane and spheres together, as many as are there now. */
    public int bodies() {
        return dimensions[Layout.BODIES];
    }

    /** How many bodies there may come to be. */
    public int room() {
        return bodySizes.length;
    }

    public int shadowSamples() {
        return (int) rayTracingProperties[Layout.SHADOW_SAMPLES];
    }

    public int bounces() {
        return (int) rayTracingProperties[Layout.BOUNCES];
    }

    /**
     * The same picture by way of another hierarchy over the same spheres, such as one of a single leaf.
     *
     * @throws IllegalArgumentException where it has another length
     */
    public FrameInput withHierarchy(float[] newHierarchy) {
        if (newHierarchy.length != hierarchy.length) {
            throw new IllegalArgumentException(newHierarchy.length + " floats for " + bodies() + " bodies");
        }
        return new FrameInput(
                dimensions,
                camera,
                rayTracingProperties,
                bodyPositions,
                bodySizes,
                bodyColors,
                bodyReflectivities,
                skybox,
                skyboxDimensions,
                shadowDisc,
                pixelOffsets,
                newHierarchy);
    }

    /**
     * The same picture, of which only some rows are drawn.
     *
     * @throws IllegalArgumentException where the rows are not rows of the picture
     */
    public FrameInput band(int firstRow, int rows) {
        if (firstRow < 0 || rows < 1 || firstRow > height() - rows) {
            throw new IllegalArgumentException("rows " + firstRow + " to " + (firstRow + rows) + " of " + height());
        }
        int[] banded = dimensions.clone();
        banded[Layout.FIRST_ROW] = firstRow;
        banded[Layout.ROWS] = rows;
        return with(banded);
    }

    /**
     * The same view in other pixels, all of whose rows are drawn.
     *
     * @throws IllegalArgumentException where a side is below 1
     */
    public FrameInput withSize(int width, int height) {
        if (width < 1 || height < 1) {
            throw new IllegalArgumentException("a picture of " + width + " x " + height);
        }
        int[] sized = dimensions.clone();
        sized[Layout.WIDTH] = width;
        sized[Layout.HEIGHT] = height;
        sized[Layout.FIRST_ROW] = 0;
        sized[Layout.ROWS] = height;
        return with(sized);
    }

    private FrameInput with(int[] newDimensions) {
        return new FrameInput(
                newDimensions,
                camera,
                rayTracingProperties,
                bodyPositions,
                bodySizes,
                bodyColors,
                bodyReflectivities,
                skybox,
                skyboxDimensions,
                shadowDisc,
                pixelOffsets,
                hierarchy);
    }

    /**
     * The same, but what looks the same as in an earlier snapshot (sizes, colours, reflectivities, the sky's size) in that
     * one's arrays, so that an engine that knows arrays by their identity has nothing new to send.
     */
    public FrameInput withLooksOf(FrameInput earlier) {
        return new FrameInput(
                dimensions,
                camera,
                rayTracingProperties,
                bodyPositions,
                kept(earlier.bodySizes, bodySizes),
                kept(earlier.bodyColors, bodyColors),
                kept(earlier.bodyReflectivities, bodyReflectivities),
                skybox,
                Arrays.equals(earlier.skyboxDimensions, skyboxDimensions) ? earlier.skyboxDimensions : skyboxDimensions,
                shadowDisc,
                pixelOffsets,
                hierarchy);
    }

    private static float[] kept(float[] old, float[] fresh) {
        return Arrays.equals(old, fresh) ? old : fresh;
    }

    /**
     * The same picture by other samples: as many of the sequence that a pixel's samples are taken from, beginning with
     * that one. Runs that follow each other, each weighed by its samples, come to the picture with as many samples in one.
     *
     * @throws IllegalArgumentException where there is no sample, or a place below 0
     */
    public FrameInput withSamples(int first, int samples) {
        if (first < 0 || samples < 1) {
            throw new IllegalArgumentException(samples + " samples from " + first);
        }
        float[] properties = rayTracingProperties.clone();
        properties[Layout.PIXEL_SAMPLES] = samples;
        return new FrameInput(
                dimensions,
                camera,
                properties,
                bodyPositions,
                bodySizes,
                bodyColors,
                bodyReflectivities,
                skybox,
                skyboxDimensions,
                shadowDisc,
                PixelOffsets.places(first, samples),
                hierarchy);
    }

    /**
     * Whether the hierarchy is a single leaf, as it is for few spheres, and stays one however many come: what is compiled for few
     * is not compiled anew in the middle of a pour.
     */
    public boolean hasFewSpheres() {
        return hierarchy[Layout.root(bodies()) + Layout.NODE_SPHERES] >= 0
                && room() - Layout.FIRST_SPHERE < SphereHierarchy.FEWEST_SPHERES;
    }

    public int samplesPerPixel() {
        return (int) rayTracingProperties[Layout.PIXEL_SAMPLES];
    }
}
