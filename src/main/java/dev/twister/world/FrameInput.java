package dev.twister.world;

import dev.twister.kernel.Aspect;
import dev.twister.kernel.Layout;

/**
 * A snapshot of the world as the flat arrays that the kernel reads.
 *
 * <p>The arrays of a snapshot are immutable: a changing world creates new arrays and reuses those that are still valid.
 * An engine can therefore recognize by identity that its copy of an array, such as one on a device, is still valid.
 */
public record FrameInput(View view, Bodies bodies, Panorama panorama) {

    public int width() {
        return view.dimensions()[Layout.WIDTH];
    }

    public int height() {
        return view.dimensions()[Layout.HEIGHT];
    }

    public int firstRow() {
        return view.dimensions()[Layout.FIRST_ROW];
    }

    public int rows() {
        return view.dimensions()[Layout.ROWS];
    }

    /** Number of present bodies without meshes: light, plane and spheres. */
    public int bodyCount() {
        return view.dimensions()[Layout.BODIES];
    }

    /** One more than the highest number of a present body, including meshes. */
    public int bodyEnd() {
        return bodies.firstMesh() == Layout.NO_MESHES ? bodyCount() : bodies.places().length / Layout.PLACE_STRIDE;
    }

    public int shadowSamples() {
        return (int) view.properties()[Layout.SHADOW_SAMPLES];
    }

    public int bounces() {
        return (int) view.properties()[Layout.BOUNCES];
    }

    public int samplesPerPixel() {
        return (int) view.properties()[Layout.PIXEL_SAMPLES];
    }

    /** Which aspect of the picture is rendered: a constant of {@link Aspect}. */
    public int aspect() {
        return view.aspect();
    }

    /** Whether 8-bit pixels are sRGB-encoded. */
    public boolean srgb() {
        return view.properties()[Layout.SRGB] > 0;
    }

    /**
     * The same picture with another hierarchy over the same spheres, such as one with a single leaf.
     *
     * @throws IllegalArgumentException if its length differs
     */
    public FrameInput withHierarchy(float[] hierarchy) {
        if (hierarchy.length != bodies.hierarchy().length) {
            throw new IllegalArgumentException(hierarchy.length + " floats for " + bodyCount() + " bodies");
        }
        return new FrameInput(view, bodies.withHierarchy(hierarchy), panorama);
    }

    /**
     * A band of the picture: only some rows are rendered.
     *
     * @throws IllegalArgumentException if the rows are not in the picture
     */
    public FrameInput band(int firstRow, int rows) {
        if (firstRow < 0 || rows < 1 || firstRow > height() - rows) {
            throw new IllegalArgumentException("rows " + firstRow + " to " + (firstRow + rows) + " of " + height());
        }
        return with(view.withRows(firstRow, rows));
    }

    /**
     * The same view in another size, with all rows.
     *
     * @throws IllegalArgumentException if a side is below 1
     */
    public FrameInput withSize(int width, int height) {
        if (width < 1 || height < 1) {
            throw new IllegalArgumentException("a picture of " + width + " x " + height);
        }
        return with(view.withSize(width, height));
    }

    /**
     * The same picture with a run of consecutive samples from the sequence of pixel samples; number 0 is the pixel's
     * center. The mean of adjacent runs, weighted by their samples, equals one long run.
     *
     * @throws IllegalArgumentException if {@code first} is negative or {@code samples} below 1
     */
    public FrameInput withSamples(int first, int samples) {
        if (first < 0 || samples < 1) {
            throw new IllegalArgumentException(samples + " samples from " + first);
        }
        return with(view.withSamples(first, samples));
    }

    /**
     * A stage or view of this picture. 8-bit frames show the values as if they were colors; linear frames hold the
     * values themselves.
     */
    public FrameInput showing(Picture picture) {
        return with(view.showing(picture));
    }

    private FrameInput with(View newView) {
        return new FrameInput(newView, bodies, panorama);
    }

    /**
     * The same snapshot, but with an earlier snapshot's arrays where they are equal (looks, the sky's size), so that an
     * engine that compares arrays by identity transfers nothing.
     */
    public FrameInput withLooksOf(FrameInput earlier) {
        return new FrameInput(view, bodies.withLooksOf(earlier.bodies), panorama.withDimensionsOf(earlier.panorama));
    }

    /**
     * Whether the hierarchy is a single leaf, and stays one during a pour, so that code compiled for few spheres stays
     * valid.
     */
    public boolean hasFewSpheres() {
        return bodies.hierarchy()[Layout.root(bodyCount()) + Layout.NODE_SPHERES] >= 0
                && bodies.room() - Layout.FIRST_SPHERE < SphereHierarchy.FEWEST_SPHERES;
    }
}
