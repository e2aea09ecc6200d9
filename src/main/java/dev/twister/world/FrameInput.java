package dev.twister.world;

import dev.twister.kernel.Aspect;
import dev.twister.kernel.Layout;

/**
 * A snapshot of the world as the flat arrays that the kernel reads.
 *
 * <p>No array changes once it is in a snapshot: a world that moves on makes new ones and keeps those that still hold.
 * So an engine may know by the array's identity that what it holds (on a device, say) is still right.
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

    /** Light, plane and spheres together, as many as are there now, without meshes. */
    public int bodyCount() {
        return view.dimensions()[Layout.BODIES];
    }

    /** One more than the highest number of a body that is there, meshes included. */
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

    /** What of the picture is drawn: one of {@link Aspect}'s numbers. */
    public int aspect() {
        return view.aspect();
    }

    /** Whether 8-bit pixels are sRGB-encoded. */
    public boolean srgb() {
        return view.properties()[Layout.SRGB] > 0;
    }

    /**
     * The same picture by way of another hierarchy over the same spheres, such as one of a single leaf.
     *
     * @throws IllegalArgumentException where it has another length
     */
    public FrameInput withHierarchy(float[] hierarchy) {
        if (hierarchy.length != bodies.hierarchy().length) {
            throw new IllegalArgumentException(hierarchy.length + " floats for " + bodyCount() + " bodies");
        }
        return new FrameInput(view, bodies.withHierarchy(hierarchy), panorama);
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
        return with(view.withRows(firstRow, rows));
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
        return with(view.withSize(width, height));
    }

    /**
     * The same picture by other samples: as many of the sequence that a pixel's samples are taken from, beginning with
     * that one; number 0 is the pixel's center. Runs that follow each other, each weighed by its samples, come to one
     * run of as many.
     *
     * @throws IllegalArgumentException where there is no sample, or a place below 0
     */
    public FrameInput withSamples(int first, int samples) {
        if (first < 0 || samples < 1) {
            throw new IllegalArgumentException(samples + " samples from " + first);
        }
        return with(view.withSamples(first, samples));
    }

    /**
     * A stage or a view of the picture that this one draws. Pixels of 8 bits show colors as ever, and numbers as if
     * they were colors; linear frames have the numbers themselves.
     */
    public FrameInput showing(Picture picture) {
        return with(view.showing(picture));
    }

    private FrameInput with(View newView) {
        return new FrameInput(newView, bodies, panorama);
    }

    /**
     * The same, but what is the same as in an earlier snapshot (looks, the sky's size) in that one's arrays, so that an
     * engine that knows arrays by their identity has nothing new to send.
     */
    public FrameInput withLooksOf(FrameInput earlier) {
        return new FrameInput(view, bodies.withLooksOf(earlier.bodies), panorama.withDimensionsOf(earlier.panorama));
    }

    /**
     * Whether the hierarchy is a single leaf, as it is for few spheres, and stays one however many come: what is
     * compiled for few is not compiled anew in the middle of a pour.
     */
    public boolean hasFewSpheres() {
        return bodies.hierarchy()[Layout.root(bodyCount()) + Layout.NODE_SPHERES] >= 0
                && bodies.room() - Layout.FIRST_SPHERE < SphereHierarchy.FEWEST_SPHERES;
    }
}
