package dev.twister.engine.tornado;

import java.util.Arrays;
import java.util.List;
import uk.ac.manchester.tornado.api.WorkerGrid2D;
import uk.ac.manchester.tornado.api.enums.TornadoDeviceType;

/**
 * The size of the work-groups of a kernel: the fastest of a few, by the times of its first frames. Grids are rounded up
 * to whole groups, so that all sizes of pictures have groups of the same size.
 */
final class WorkGroups {
    /** Each group size renders this number of frames, of which the fastest counts. */
    private static final int TRIALS = 2;

    /** Multiples of the warps of GPUs (32 or 64 work-items), small enough for kernels with 255 registers. */
    private static final List<Group> OF_GPUS = List.of(new Group(8, 8), new Group(16, 8), new Group(32, 4));

    /** Wide enough for a processor's vectors, in which some drivers put neighboring work-items. */
    private static final List<Group> OF_PROCESSORS = List.of(new Group(64, 4), new Group(32, 32), new Group(16, 8));

    private final List<Group> groups;
    private final double[] nanosPerPixel;
    private int frames;

    /** Work-items of a group: columns and rows of the picture. */
    record Group(int columns, int rows) {}

    /**
     * The groups that a device takes.
     *
     * @param mostItems of a group on the device
     */
    WorkGroups(TornadoDeviceType type, long mostItems) {
        List<Group> usual = type == TornadoDeviceType.CPU ? OF_PROCESSORS : OF_GPUS;
        List<Group> fitting = usual.stream()
                .filter(group -> (long) group.columns() * group.rows() <= mostItems)
                .toList();
        groups = fitting.isEmpty() ? List.of(new Group(1, 1)) : fitting;
        nanosPerPixel = new double[groups.size()];
        Arrays.fill(nanosPerPixel, Double.POSITIVE_INFINITY);
    }

    /** The group size for the next frame. */
    Group next() {
        return groups.get(isChosen() ? fastest() : trial());
    }

    /** Whether all group sizes were tried. */
    boolean isChosen() {
        return frames == TRIALS * groups.size();
    }

    /** Takes the kernel's time for a frame with the group size of {@link #next}. */
    void measured(long kernelNanos, long pixels) {
        if (!isChosen()) {
            nanosPerPixel[trial()] = Math.min(nanosPerPixel[trial()], (double) kernelNanos / pixels);
            frames++;
        }
    }

    private int trial() {
        return frames % groups.size();
    }

    private int fastest() {
        int fastest = 0;
        for (int i = 1; i < groups.size(); i++) {
            fastest = nanosPerPixel[i] < nanosPerPixel[fastest] ? i : fastest;
        }
        return fastest;
    }

    /** Sets a grid that covers all pixels with whole groups. */
    static void cover(WorkerGrid2D grid, Group group, int width, int rows) {
        grid.setGlobalWork(whole(width, group.columns()), whole(rows, group.rows()), 1);
        grid.setLocalWork(group.columns(), group.rows(), 1);
    }

    private static int whole(int pixels, int group) {
        return Math.ceilDiv(pixels, group) * group;
    }
}
