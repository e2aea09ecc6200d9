package dev.twister.engine.vector.mesh;

import dev.twister.engine.vector.frame.Drawing;
import dev.twister.engine.vector.lanes.Lanes;
import dev.twister.engine.vector.lanes.ShadowColumns;
import dev.twister.engine.vector.lanes.Tile;
import dev.twister.engine.vector.shadow.ShadowFrame;
import jdk.incubator.vector.FloatVector;
import jdk.incubator.vector.VectorMask;
import jdk.incubator.vector.VectorOperators;

/** Lines from a packet's points to light samples, as rays of a traversal. */
final class ShadowLines {
    /** End of an inactive line. */
    private static final float BLOCKED = -1f;

    private ShadowLines() {}

    /** Writes each point's disc axes and the origins of its lines. */
    static void findAxes(Tile tile, int at, Drawing drawing, MeshBench bench) {
        ShadowFrame.findAxes(tile, at, drawing, bench.shadows.columns);
        float[] t = tile.values;
        for (int axis = 0; axis < 3; axis++) {
            FloatVector.fromArray(Lanes.FLOATS, t, at + Tile.POINT_X + axis * Tile.SIZE)
                    .intoArray(bench.world.rays, PacketWalk.ORIGIN + axis * Lanes.COUNT);
        }
    }

    /**
     * Aims the lines of some lanes at a sample of the unit disc, where they end; returns the first of those lanes.
     *
     * @param lanes one bit per lane, at least one
     */
    static long aim(Tile tile, int at, MeshBench bench, long lanes, float discX, float discY) {
        float[] t = tile.values;
        float[] r = bench.world.rays;
        float[] frame = bench.shadows.columns.frame;
        FloatVector scale = FloatVector.fromArray(Lanes.FLOATS, frame, ShadowColumns.SCALE);
        FloatVector x = scale.mul(discX);
        FloatVector y = scale.mul(discY);
        FloatVector distance = FloatVector.fromArray(Lanes.FLOATS, t, at + Tile.LIGHT_DISTANCE);
        FloatVector.fromArray(Lanes.FLOATS, t, at + Tile.TO_LIGHT_X)
                .add(y.mul(FloatVector.fromArray(Lanes.FLOATS, frame, ShadowColumns.W_X)))
                .mul(distance)
                .intoArray(r, PacketWalk.DIRECTION);
        FloatVector.fromArray(Lanes.FLOATS, t, at + Tile.TO_LIGHT_Y)
                .add(x.mul(FloatVector.fromArray(Lanes.FLOATS, frame, ShadowColumns.U_Y)))
                .add(y.mul(FloatVector.fromArray(Lanes.FLOATS, frame, ShadowColumns.W_Y)))
                .mul(distance)
                .intoArray(r, PacketWalk.DIRECTION + Lanes.COUNT);
        FloatVector.fromArray(Lanes.FLOATS, t, at + Tile.TO_LIGHT_Z)
                .add(x.mul(FloatVector.fromArray(Lanes.FLOATS, frame, ShadowColumns.U_Z)))
                .add(y.mul(FloatVector.fromArray(Lanes.FLOATS, frame, ShadowColumns.W_Z)))
                .mul(distance)
                .intoArray(r, PacketWalk.DIRECTION + 2 * Lanes.COUNT);
        FloatVector.broadcast(Lanes.FLOATS, BLOCKED)
                .blend(1f, VectorMask.fromLong(Lanes.FLOATS, lanes))
                .intoArray(r, PacketWalk.END);
        FloatVector.broadcast(Lanes.FLOATS, 0f)
                .blend(1f, VectorMask.fromLong(Lanes.FLOATS, lanes))
                .intoArray(bench.aimed, Lanes.BORDER);
        return Long.numberOfTrailingZeros(lanes);
    }

    /** Counts the aimed lines that were blocked; returns one bit per blocked line. */
    static long count(Tile tile, MeshBench bench) {
        VectorMask<Float> blocked = FloatVector.fromArray(Lanes.FLOATS, bench.world.rays, PacketWalk.END)
                .compare(VectorOperators.LT, 0f)
                .and(FloatVector.fromArray(Lanes.FLOATS, bench.aimed, Lanes.BORDER)
                        .compare(VectorOperators.GT, 0f));
        FloatVector count = FloatVector.fromArray(Lanes.FLOATS, bench.blocked, Lanes.BORDER);
        count.blend(count.add(1f), blocked).intoArray(bench.blocked, Lanes.BORDER);
        return blocked.toLong();
    }

    /** One bit per lane in which all samples are blocked. */
    static long hidden(Tile tile, MeshBench bench, int samples) {
        return FloatVector.fromArray(Lanes.FLOATS, bench.blocked, Lanes.BORDER)
                .compare(VectorOperators.GE, samples)
                .toLong();
    }

    /** Closes the lanes in full shadow, and writes the blocked samples of partly shaded lanes. */
    static void finish(Tile tile, int at, MeshBench bench, long dark, long part, long unknown) {
        float[] t = tile.values;
        FloatVector.fromArray(Lanes.FLOATS, t, at + Tile.VISIBLE)
                .blend(0f, VectorMask.fromLong(Lanes.FLOATS, dark))
                .intoArray(t, at + Tile.VISIBLE);
        FloatVector.fromArray(Lanes.FLOATS, t, at + Tile.SHADOW_OPEN)
                .blend(0f, VectorMask.fromLong(Lanes.FLOATS, dark))
                .intoArray(t, at + Tile.SHADOW_OPEN);
        FloatVector.broadcast(Lanes.FLOATS, 0f)
                .blend(
                        FloatVector.fromArray(Lanes.FLOATS, bench.blocked, Lanes.BORDER),
                        VectorMask.fromLong(Lanes.FLOATS, part))
                .blend(MeshShadows.UNKNOWN, VectorMask.fromLong(Lanes.FLOATS, unknown))
                .intoArray(t, at + Tile.MESH_BLOCKED);
    }
}
