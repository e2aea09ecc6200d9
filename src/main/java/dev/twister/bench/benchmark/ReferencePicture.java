package dev.twister.bench.benchmark;

import dev.twister.engine.Engine;
import dev.twister.image.Frame;
import dev.twister.world.FrameInput;
import java.util.Arrays;
import java.util.BitSet;
import java.util.Collections;
import java.util.List;
import java.util.Random;
import java.util.stream.Collectors;
import java.util.stream.IntStream;

/**
 * The picture to which those of engines are compared, or rows of it, spread evenly, where all of them take too long.
 *
 * @param frame black in the other rows
 * @param rows those that were rendered, at least one
 * @param secondsOfAll the time that all rows take, estimated from these
 */
record ReferencePicture(Frame frame, BitSet rows, double secondsOfAll) {
    private static final double NANOS_PER_SECOND = 1e9;

    /**
     * Renders rows until all are done or the time is up.
     *
     * @param seconds limit, after which at most one more row is rendered
     */
    static ReferencePicture draw(Engine engine, FrameInput input, double seconds) {
        Frame frame = Frame.ofPixels(input.width(), input.height());
        List<Integer> order = IntStream.range(0, input.height()).boxed().collect(Collectors.toList());
        Collections.shuffle(order, new Random(1));
        BitSet rows = new BitSet();
        long start = System.nanoTime();
        double elapsed = 0;
        while (rows.cardinality() < order.size() && (rows.isEmpty() || elapsed < seconds)) {
            int row = order.get(rows.cardinality());
            Frame band = frame.ofRows(1);
            engine.render(input.band(row, 1), band);
            frame.put(band, row);
            rows.set(row);
            elapsed = (System.nanoTime() - start) / NANOS_PER_SECOND;
        }
        return new ReferencePicture(frame, rows, elapsed * order.size() / rows.cardinality());
    }

    boolean isWhole() {
        return rows.cardinality() == frame.height();
    }

    /** Whether all rows, of which some are left, take longer than a limit. */
    boolean takesLongerThan(double seconds) {
        return !isWhole() && secondsOfAll > seconds;
    }

    /** Compares the rows with those of a whole picture. */
    PictureComparison compare(int[] argb) {
        return PictureComparison.of(rowsOf(frame.argb()), rowsOf(argb));
    }

    private int[] rowsOf(int[] argb) {
        int width = frame.width();
        return isWhole()
                ? argb
                : rows.stream()
                        .flatMap(row -> Arrays.stream(argb, row * width, (row + 1) * width))
                        .toArray();
    }
}
