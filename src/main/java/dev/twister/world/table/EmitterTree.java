package dev.twister.world.table;

import dev.twister.kernel.Layout;
import java.util.Arrays;
import java.util.List;

/** Builds the tree over emitters that {@link Layout#LIGHTS_STRIDE} describes: halves along the longest axis. */
final class EmitterTree {
    /** With fewer emitters a choice by power alone costs less and finds as much. */
    static final int FEWEST = 8;

    private final List<Part> parts;
    private final float[] looks;
    private final int table;
    private final double[] low = new double[3];
    private final double[] high = new double[3];
    private int next;

    /**
     * An emitter: a sphere around it, its power, and the direction to which alone it emits, with those at less than a
     * right angle; a zero vector if it emits to all.
     */
    @SuppressWarnings("ArrayRecordComponent") // never compared
    record Part(double[] center, double radius, double power, double[] axis) {
        boolean emitsToAll() {
            return axis[0] == 0 && axis[1] == 0 && axis[2] == 0;
        }
    }

    private EmitterTree(List<Part> parts, float[] looks, int table, int tree) {
        this.parts = parts;
        this.looks = looks;
        this.table = table;
        next = tree;
    }

    /** Number of floats. */
    static int length(int emitters) {
        return Layout.LIGHTS_STRIDE * (2 * emitters - 1);
    }

    /**
     * Writes the tree, and the leaves of the emitters.
     *
     * @param parts the emitters in the order of their table
     * @param table place of their table
     * @param tree place of the tree
     */
    static void write(List<Part> parts, float[] looks, int table, int tree) {
        EmitterTree built = new EmitterTree(parts, looks, table, tree);
        int[] order = new int[parts.size()];
        Arrays.setAll(order, leaf -> leaf);
        built.write(order, 0, order.length);
    }

    private void write(int[] order, int start, int end) {
        int node = next;
        next += Layout.LIGHTS_STRIDE;
        bound(order, start, end, 0);
        int axis = 0;
        for (int other = 1; other < 3; other++) {
            axis = high[other] - low[other] > high[axis] - low[axis] ? other : axis;
        }
        bound(order, start, end, 1);
        writeBounds(node, order, start, end);
        if (end - start == 1) {
            looks[node + Layout.LIGHTS_EMITTER] = order[start];
            looks[table + Layout.EMITTER_STRIDE * order[start] + Layout.EMITTER_LEAF] = start;
        } else {
            sort(order, start, end, axis);
            int middle = (start + end) / 2;
            write(order, start, middle);
            write(order, middle, end);
        }
    }

    /**
     * The box around some emitters.
     *
     * @param radii 1 with their radii, 0 around their centers
     */
    private void bound(int[] order, int start, int end, int radii) {
        Arrays.fill(low, Double.POSITIVE_INFINITY);
        Arrays.fill(high, Double.NEGATIVE_INFINITY);
        for (int leaf = start; leaf < end; leaf++) {
            Part part = parts.get(order[leaf]);
            for (int axis = 0; axis < 3; axis++) {
                low[axis] = Math.min(low[axis], part.center()[axis] - radii * part.radius());
                high[axis] = Math.max(high[axis], part.center()[axis] + radii * part.radius());
            }
        }
    }

    private void writeBounds(int node, int[] order, int start, int end) {
        double[] center = new double[3];
        double[] mean = new double[3];
        double power = 0;
        boolean all = false;
        for (int leaf = start; leaf < end; leaf++) {
            Part part = parts.get(order[leaf]);
            power += part.power();
            all |= part.emitsToAll();
            for (int axis = 0; axis < 3; axis++) {
                mean[axis] += part.axis()[axis];
            }
        }
        for (int axis = 0; axis < 3; axis++) {
            center[axis] = (low[axis] + high[axis]) / 2;
            looks[node + Layout.LIGHTS_CENTER + axis] = (float) center[axis];
        }
        double radius = 0;
        double length = Math.sqrt(dot(mean, mean));
        double cosine = all || length == 0 ? -1 : 1;
        for (int leaf = start; leaf < end; leaf++) {
            Part part = parts.get(order[leaf]);
            double[] away = new double[3];
            Arrays.setAll(away, axis -> part.center()[axis] - center[axis]);
            radius = Math.max(radius, Math.sqrt(dot(away, away)) + part.radius());
            if (cosine > -1) {
                cosine = Math.min(cosine, dot(part.axis(), mean) / length);
            }
        }
        looks[node + Layout.LIGHTS_RADIUS] = (float) radius;
        looks[node + Layout.LIGHTS_POWER] = (float) power;
        looks[node + Layout.LIGHTS_COSINE] = (float) cosine;
        looks[node + Layout.LIGHTS_SINE] = (float) Math.sqrt(Math.max(0, 1 - cosine * cosine));
        for (int axis = 0; axis < 3 && cosine > -1; axis++) {
            looks[node + Layout.LIGHTS_AXIS + axis] = (float) (mean[axis] / length);
        }
    }

    static double dot(double[] one, double[] other) {
        return one[0] * other[0] + one[1] * other[1] + one[2] * other[2];
    }

    private void sort(int[] order, int start, int end, int axis) {
        int[] sorted = Arrays.stream(order, start, end)
                .boxed()
                .sorted((one, other) -> Double.compare(
                        parts.get(one).center()[axis], parts.get(other).center()[axis]))
                .mapToInt(part -> part)
                .toArray();
        System.arraycopy(sorted, 0, order, start, sorted.length);
    }
}
