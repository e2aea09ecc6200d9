package dev.twister.engine.tornado;

import dev.twister.engine.EngineException;
import dev.twister.image.Frame;
import dev.twister.image.FrameTimes;
import dev.twister.kernel.Layout;
import dev.twister.scene.Rendering;
import dev.twister.world.FrameInput;
import java.util.Arrays;
import uk.ac.manchester.tornado.api.GridScheduler;
import uk.ac.manchester.tornado.api.TaskGraph;
import uk.ac.manchester.tornado.api.TornadoExecutionPlan;
import uk.ac.manchester.tornado.api.TornadoExecutionResult;
import uk.ac.manchester.tornado.api.TornadoProfilerResult;
import uk.ac.manchester.tornado.api.WorkerGrid;
import uk.ac.manchester.tornado.api.WorkerGrid2D;
import uk.ac.manchester.tornado.api.common.TornadoDevice;
import uk.ac.manchester.tornado.api.enums.DataTransferMode;
import uk.ac.manchester.tornado.api.enums.ProfilerMode;
import uk.ac.manchester.tornado.api.enums.TornadoDeviceType;
import uk.ac.manchester.tornado.api.enums.TornadoVMBackendType;

/**
 * The kernel compiled for one device and one picture size, with its device buffers. The images and the meshes are
 * copied once, and so are the looks of scenes with many bodies. Frame, bodies and the looks of few bodies are copied
 * each frame. Only pixels are copied back.
 */
final class DevicePlan implements AutoCloseable {
    private static final String GRAPH = "twister";
    private static final String TASK = "draw";
    private static final int NOT_DRAWN = 0;

    /**
     * Up to this number of bodies their looks are copied each frame, which is cheaper than a new plan when a color
     * changes.
     */
    private static final int FEW_BODIES = 4096;

    /** Length of the kernel's frame with the most samples. */
    private static final int LONGEST_FRAME = Layout.DISC
            + 2 * Rendering.MAX_SHADOW_SAMPLES
            + Layout.SAMPLE_STRIDE * Rendering.MAX_SAMPLES_PER_PIXEL
            + Layout.MOST_TILES;

    private static final int[] NO_PIXELS = new int[1];
    private static final float[] NO_RADIANCE = new float[1];

    private final FrameInput fixed;
    private final boolean linear;
    private final int[] pixels;
    private final float[] radiance;
    private final float[] view = new float[LONGEST_FRAME];
    private final float[] bodies;
    private final float[] looks;
    private final TornadoExecutionPlan plan;
    private boolean proven;
    private Copied lastCopied = new Copied(0, 0);

    /** Bytes copied to and from the device for one frame. */
    record Copied(long bytesIn, long bytesOut) {}

    DevicePlan(TornadoDevice device, FrameInput input, boolean linear, DrawTask kernel) {
        fixed = input;
        this.linear = linear;
        int count = Math.multiplyExact(input.width(), input.rows());
        pixels = linear ? NO_PIXELS.clone() : new int[count];
        radiance = linear ? new float[Math.multiplyExact(3 * (1 + input.layers()), count)] : NO_RADIANCE.clone();
        if (linear) {
            Arrays.fill(radiance, Float.NaN);
        }
        bodies = input.bodies().floats().clone();
        looks = input.bodies().looks().clone();
        float[] meshes = input.bodies().meshes();
        float[] images = input.images();
        TaskGraph graph = new TaskGraph(GRAPH)
                .transferToDevice(DataTransferMode.FIRST_EXECUTION, pixels, radiance, images, meshes)
                .transferToDevice(
                        sendsLooks() ? DataTransferMode.EVERY_EXECUTION : DataTransferMode.FIRST_EXECUTION, looks)
                .transferToDevice(DataTransferMode.EVERY_EXECUTION, view, bodies)
                .task(
                        TASK,
                        kernel,
                        pixels,
                        radiance,
                        view,
                        bodies,
                        looks,
                        meshes,
                        images,
                        input.width(),
                        input.rows(),
                        input.variant(linear))
                .transferToHost(DataTransferMode.EVERY_EXECUTION, linear ? radiance : pixels);
        plan = new TornadoExecutionPlan(graph.snapshot());
        plan.withDevice(device)
                .withProfiler(ProfilerMode.SILENT)
                .withCompilerFlags(TornadoVMBackendType.OPENCL, OpenClFlags.forPlatform(device.getPlatformName()));
        if (device.getDeviceType() != TornadoDeviceType.CPU) {
            // TornadoVM's default work-group may exceed a GPU's registers; the driver's default fits.
            WorkerGrid grid = new WorkerGrid2D(input.width(), input.rows());
            plan.withGridScheduler(new GridScheduler(GRAPH + "." + TASK, grid));
        }
    }

    /** Whether the compiled kernel and the data on the device are valid for this frame. */
    @SuppressWarnings("ReferenceEquality") // a snapshot's arrays are immutable; a change replaces the array
    boolean fits(FrameInput input, Frame frame) {
        return input.width() == fixed.width()
                && input.rows() == fixed.rows()
                && frame.isLinear() == linear
                && input.bodies().room() == fixed.bodies().room()
                && input.bodies().floats().length == fixed.bodies().floats().length
                && input.bodies().looks().length == fixed.bodies().looks().length
                && input.bodies().meshes() == fixed.bodies().meshes()
                && input.variant(linear) == fixed.variant(linear)
                && input.images() == fixed.images()
                && (sendsLooks() || input.bodies().looks() == fixed.bodies().looks());
    }

    private boolean sendsLooks() {
        return fixed.bodies().room() <= FEW_BODIES;
    }

    /**
     * Renders a frame on the device.
     *
     * @throws EngineException if the device did not run the kernel, even if TornadoVM reports no error
     */
    FrameTimes draw(FrameInput input, Frame frame) {
        long start = System.nanoTime();
        put(input.view().frame(), view);
        put(input.bodies().floats(), bodies);
        if (sendsLooks()) {
            put(input.bodies().looks(), looks);
        }
        TornadoExecutionResult result = plan.execute();
        TornadoProfilerResult profile = result.getProfilerResult();
        lastCopied = new Copied(profile.getTotalBytesCopyIn(), profile.getTotalBytesCopyOut());
        requireKernelRan(profile);
        if (linear) {
            int plane = frame.radiance().length;
            System.arraycopy(radiance, 0, frame.radiance(), 0, plane);
            System.arraycopy(radiance, plane, frame.layers(), 0, frame.layers().length);
        } else {
            System.arraycopy(pixels, 0, frame.argb(), 0, pixels.length);
        }
        return new FrameTimes(
                System.nanoTime() - start,
                profile.getDeviceKernelTime(),
                profile.getDeviceWriteTime(),
                profile.getDeviceReadTime());
    }

    /**
     * TornadoVM and drivers can fail without an exception: no kernel time, nothing read back, or pixels left unchanged.
     * The last is checked in a plan's first frame, whose buffers start with marker values.
     */
    private void requireKernelRan(TornadoProfilerResult profile) {
        if (profile.getDeviceKernelTime() <= 0 || profile.getTotalBytesCopyOut() <= 0) {
            throw new EngineException("the device ran no kernel: TornadoVM reports " + profile.getDeviceKernelTime()
                    + " ns of kernel time and " + profile.getTotalBytesCopyOut() + " bytes read back");
        }
        if (!proven) {
            for (int pixel : pixels) {
                if (pixel == NOT_DRAWN && !linear) {
                    throw new EngineException("the device left pixels undrawn; its driver may have refused the grid of "
                            + fixed.width() + " x " + fixed.rows());
                }
            }
            if (linear && Float.isNaN(radiance[0]) && Float.isNaN(radiance[radiance.length - 1])) {
                throw new EngineException("the device left the picture undrawn");
            }
            proven = true;
        }
    }

    private static void put(float[] from, float[] to) {
        System.arraycopy(from, 0, to, 0, from.length);
    }

    Copied lastCopied() {
        return lastCopied;
    }

    /** Frees the device's buffers; a failure, as with a lost device, is only logged. */
    @Override
    public void close() {
        Release.quietly(plan::freeDeviceMemory);
        Release.quietly(plan::close);
    }
}
