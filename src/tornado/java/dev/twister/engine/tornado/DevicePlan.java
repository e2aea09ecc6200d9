package dev.twister.engine.tornado;

import dev.twister.engine.EngineException;
import dev.twister.image.Frame;
import dev.twister.image.FrameTimes;
import dev.twister.world.FrameInput;
import uk.ac.manchester.tornado.api.GridScheduler;
import uk.ac.manchester.tornado.api.TaskGraph;
import uk.ac.manchester.tornado.api.TornadoExecutionPlan;
import uk.ac.manchester.tornado.api.TornadoExecutionResult;
import uk.ac.manchester.tornado.api.TornadoProfilerResult;
import uk.ac.manchester.tornado.api.WorkerGrid2D;
import uk.ac.manchester.tornado.api.common.TornadoDevice;
import uk.ac.manchester.tornado.api.enums.DataTransferMode;
import uk.ac.manchester.tornado.api.enums.ProfilerMode;
import uk.ac.manchester.tornado.api.enums.TornadoVMBackendType;

/**
 * The kernel compiled for one device and one variant, with its device buffers, which have room for other sizes of
 * pictures and other numbers of bodies. The images and the meshes are copied once, and so are the looks of scenes with
 * many bodies. Frame, bodies and the looks of few bodies are copied each frame. Only the frame's pixels are copied
 * back.
 */
final class DevicePlan implements AutoCloseable {
    private static final String GRAPH = "twister";
    private static final String TASK = "draw";

    /**
     * Up to this number of bodies their looks are copied each frame, which is cheaper than a new plan when a color
     * changes.
     */
    private static final int FEW_BODIES = 4096;

    private final FrameInput fixed;
    private final boolean linear;
    private final WorkGroups groups;
    private final WorkerGrid2D grid;
    private final DeviceOutput output;
    private final float[] view = new float[TornadoKernel.FIRST_PIXEL + 1];
    private final float[] bodies;
    private final float[] looks;
    private final TornadoExecutionPlan plan;
    private boolean proven;
    private Copied lastCopied = new Copied(0, 0);

    /** Bytes copied to the device for one frame, as TornadoVM reports, and those of its pixels, which come back. */
    record Copied(long bytesIn, long bytesOut) {}

    /**
     * Makes the plan; the kernel is compiled with the first frame.
     *
     * @param groups of the device, not tried yet
     */
    DevicePlan(TornadoDevice device, FrameInput input, boolean linear, DrawTask kernel, WorkGroups groups) {
        fixed = input;
        this.linear = linear;
        this.groups = groups;
        output = new DeviceOutput(input, linear);
        bodies = new float[Room.ofFloats(input.bodies().floats().length)];
        looks = sendsLooks(input)
                ? new float[Room.ofFloats(input.bodies().looks().length)]
                : input.bodies().looks();
        float[] meshes = input.bodies().meshes();
        float[] images = input.images();
        TaskGraph graph = new TaskGraph(GRAPH)
                .transferToDevice(
                        DataTransferMode.FIRST_EXECUTION,
                        output.pixels(),
                        output.radiance(),
                        output.layers(),
                        images,
                        meshes)
                .transferToDevice(
                        sendsLooks(input) ? DataTransferMode.EVERY_EXECUTION : DataTransferMode.FIRST_EXECUTION, looks)
                .transferToDevice(DataTransferMode.EVERY_EXECUTION, view, bodies)
                .task(
                        TASK,
                        kernel,
                        output.pixels(),
                        output.radiance(),
                        output.layers(),
                        view,
                        bodies,
                        looks,
                        meshes,
                        images,
                        input.variant(linear))
                .transferToHost(DataTransferMode.UNDER_DEMAND, output.picture());
        if (input.layers() > 0) {
            graph.transferToHost(DataTransferMode.EVERY_EXECUTION, output.layers());
        }
        grid = new WorkerGrid2D(input.width(), input.rows());
        plan = new TornadoExecutionPlan(graph.snapshot());
        plan.withDevice(device)
                .withProfiler(ProfilerMode.SILENT)
                .withCompilerFlags(TornadoVMBackendType.OPENCL, OpenClFlags.forPlatform(device.getPlatformName()));
        plan.withGridScheduler(new GridScheduler(GRAPH + "." + TASK, grid));
    }

    /** Whether the compiled kernel and the data on the device are valid for this frame, and the buffers have room. */
    @SuppressWarnings("ReferenceEquality") // a snapshot's arrays are immutable; a change replaces the array
    boolean fits(FrameInput input, Frame frame) {
        return output.fits(input, frame)
                && Room.fits(bodies.length, input.bodies().floats().length)
                && sendsLooks(input) == sendsLooks(fixed)
                && (sendsLooks(input)
                        ? Room.fits(looks.length, input.bodies().looks().length)
                        : input.bodies().looks() == looks)
                && input.bodies().meshes() == fixed.bodies().meshes()
                && input.variant(linear) == fixed.variant(linear)
                && input.images() == fixed.images();
    }

    private static boolean sendsLooks(FrameInput input) {
        return input.bodies().room() <= FEW_BODIES;
    }

    /**
     * Renders a frame on the device.
     *
     * @throws EngineException if the device did not run the kernel, even if TornadoVM reports no error
     */
    FrameTimes draw(FrameInput input, Frame frame) {
        long start = System.nanoTime();
        put(input.view().frame(), view);
        int firstPixel = output.firstPixel(frame);
        view[TornadoKernel.FIRST_PIXEL] = firstPixel;
        put(input.bodies().floats(), bodies);
        if (sendsLooks(input)) {
            put(input.bodies().looks(), looks);
        }
        WorkGroups.cover(grid, groups.next(), input.width(), input.rows());
        TornadoExecutionResult result = plan.execute();
        // Reading the picture clears what TornadoVM has measured until then.
        TornadoProfilerResult profile = result.getProfilerResult();
        long kernelNanos = profile.getDeviceKernelTime();
        long inNanos = profile.getDeviceWriteTime();
        lastCopied = new Copied(profile.getTotalBytesCopyIn(), DeviceOutput.bytes(input, linear));
        if (kernelNanos <= 0) {
            throw new EngineException("the device ran no kernel: TornadoVM reports " + kernelNanos + " ns");
        }
        long outNanos = output.read(result, input, frame, firstPixel);
        if (!proven) {
            output.requireDrawn(input, firstPixel);
            proven = true;
        }
        groups.measured(kernelNanos, (long) input.width() * input.rows());
        return new FrameTimes(System.nanoTime() - start, kernelNanos, inNanos, outNanos);
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
