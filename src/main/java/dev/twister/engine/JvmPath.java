package dev.twister.engine;

import dev.twister.image.Frame;
import dev.twister.kernel.Layout;
import dev.twister.kernel.PathTracer;
import dev.twister.kernel.PixelKernel;
import dev.twister.world.Bodies;
import dev.twister.world.FrameInput;

/** One pixel's traced path on the JVM, which the kernel follows ray by ray. Its hits may be found elsewhere. */
public final class JvmPath {
    private final float[] path = new float[Layout.LAYERED_PATH_LENGTH];
    private final float[] scratch;
    private int ray = PathTracer.NO_RAY;
    private int bounce;

    /**
     * Creates a path without rays.
     *
     * @param scratch {@link Layout#LAYERED_SCRATCH_LENGTH} floats, which the paths of one thread may share
     */
    public JvmPath(float[] scratch) {
        this.scratch = scratch;
    }

    /** The path's floats: {@link Layout#PATH_LENGTH} and those of {@link PathTracer}. */
    public float[] floats() {
        return path;
    }

    /** Sets the sum of the samples to black. */
    public void blacken() {
        path[Layout.RADIANCE] = 0f;
        path[Layout.RADIANCE + 1] = 0f;
        path[Layout.RADIANCE + 2] = 0f;
    }

    /** Starts a sample's view ray; the row is that of the band. */
    public void start(FrameInput input, int column, int row, int sample) {
        PixelKernel.start(path, column, row, sample, input.view().frame());
        PathTracer.begin(path, input.view().frame(), input.variant(false));
        ray = PathTracer.TO_SURFACE;
        bounce = 0;
    }

    /** Whether there is another ray to follow. */
    public boolean goesOn() {
        return ray != PathTracer.NO_RAY;
    }

    /**
     * Ends the current ray, and replaces it by the next one. {@link Layout#DISTANCE}, {@link Layout#INSTANCE} and
     * {@link Layout#TRIANGLE} describe the hit.
     *
     * @param hit the closest body
     */
    public void end(FrameInput input, int hit, int variant) {
        float[] frame = input.view().frame();
        Bodies bodies = input.bodies();
        if (ray == PathTracer.TO_EMITTER) {
            boolean blocked = path[Layout.DISTANCE] < path[Layout.LIGHT_DISTANCE];
            ray = PathTracer.light(path, blocked ? hit : Layout.NOTHING, scratch, variant);
        } else {
            ray = PathTracer.arrive(
                    path,
                    hit,
                    bounce,
                    scratch,
                    frame,
                    bodies.floats(),
                    bodies.looks(),
                    bodies.meshes(),
                    input.images(),
                    variant);
            bounce++;
        }
    }

    /** Follows the remaining rays. */
    public void finish(FrameInput input, int variant) {
        float[] frame = input.view().frame();
        Bodies bodies = input.bodies();
        while (ray != PathTracer.NO_RAY) {
            int meets = ray == PathTracer.TO_SURFACE ? 1 : 0;
            ray = PathTracer.step(
                    path,
                    bounce,
                    ray,
                    scratch,
                    frame,
                    bodies.floats(),
                    bodies.looks(),
                    bodies.meshes(),
                    input.images(),
                    variant);
            bounce += meets;
        }
    }

    /** Stores the mean of the pixel's samples. */
    public void store(FrameInput input, Frame frame, int column, int row, int variant) {
        PixelKernel.store(
                column,
                row,
                frame.argb(),
                frame.radiance(),
                frame.layers(),
                path,
                scratch,
                input.view().frame(),
                variant);
    }
}
