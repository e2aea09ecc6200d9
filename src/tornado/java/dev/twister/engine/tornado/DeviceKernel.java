package dev.twister.engine.tornado;

import dev.twister.engine.Shortcuts;
import dev.twister.kernel.Layout;
import dev.twister.kernel.PixelKernel;
import dev.twister.kernel.Strip;
import dev.twister.world.FrameInput;
import java.util.Optional;
import java.util.function.ToIntFunction;
import uk.ac.manchester.tornado.api.WorkerGrid;
import uk.ac.manchester.tornado.api.WorkerGrid1D;
import uk.ac.manchester.tornado.api.WorkerGrid2D;
import uk.ac.manchester.tornado.api.common.TornadoDevice;
import uk.ac.manchester.tornado.api.enums.TornadoDeviceType;

/**
 * A kernel as TornadoVM takes it, by which of {@link PixelKernel}'s shortcuts it draws a frame, and over which grid its
 * work-items lie. Those here are loaded once, since TornadoVM keeps what it knows of a method for good.
 */
record DeviceKernel(DrawTask task, ToIntFunction<FrameInput> shortcuts, Grid grid) {
    /** In strips the loop over all spheres takes half of the walk's time for 50 and 0.7 of it for 100. */
    private static final int MOST_SPHERES_IN_A_LOOP = 64;

    /** A work-item a pixel. */
    static final DeviceKernel PIXELS = new DeviceKernel(
            DeviceClassLoader.load(TornadoKernel.class, DrawTask.class), Shortcuts::of, DeviceKernel::pixels);

    /** A work-item a strip of pixels. */
    static final DeviceKernel STRIPS = new DeviceKernel(
            DeviceClassLoader.load(TornadoStripKernel.class, DrawTask.class),
            DeviceKernel::shortcutsOfStrips,
            DeviceKernel::strips);

    /** Chooses a grid for a picture, or none where TornadoVM's own choice will do. */
    interface Grid {
        Optional<WorkerGrid> of(TornadoDevice device, int width, int rows);
    }

    /** The fastest one for a device. */
    static DeviceKernel of(TornadoDevice device) {
        return isCpu(device) ? STRIPS : PIXELS;
    }

    private static boolean isCpu(TornadoDevice device) {
        return device.getDeviceType() == TornadoDeviceType.CPU;
    }

    /** By the room, not by the spheres there are: a scene keeps its kernel while spheres are poured. */
    private static int shortcutsOfStrips(FrameInput input) {
        return input.room() - Layout.FIRST_SPHERE <= MOST_SPHERES_IN_A_LOOP
                ? PixelKernel.FEW_SPHERES
                : PixelKernel.SHORTCUTS;
    }

    private static Optional<WorkerGrid> pixels(TornadoDevice device, int width, int rows) {
        // Left alone, TornadoVM may choose a group too large for a GPU's registers; the driver knows better.
        return isCpu(device) ? Optional.empty() : Optional.of(new WorkerGrid2D(width, rows));
    }

    private static Optional<WorkerGrid> strips(TornadoDevice device, int width, int rows) {
        WorkerGrid grid = new WorkerGrid1D(Strip.inRow(width) * rows);
        // PoCL keeps the arrays of a whole group on a thread's stack, which those of some hundred strips overflow.
        grid.setLocalWork(1, 1, 1);
        return Optional.of(grid);
    }
}
