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
    static void findAxes(Tile tile, int at, Drawing drawing, MeshMemory bench) {
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
    static long aim(Tile tile, int at, MeshMemory bench, long lanes, float discX, float discY) {
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
        FloatVector.broadcast(Lanes.FLOATS, 1f).intoArray(bench.light, Lanes.BORDER);
        return Long.numberOfTrailingZeros(lanes);
    }

    /** Dims and resumes the lines that have met a transmitting body. */
    static void pass(Tile tile, MeshMemory bench, long lanes, float transmission) {
        float[] r = bench.world.rays;
        VectorMask<Float> met = VectorMask.fromLong(Lanes.FLOATS, lanes);
        FloatVector light = FloatVector.fromArray(Lanes.FLOATS, bench.light, Lanes.BORDER);
        light.blend(light.mul(transmission), met).intoArray(bench.light, Lanes.BORDER);
        FloatVector.fromArray(Lanes.FLOATS, r, PacketWalk.END).blend(1f, met).intoArray(r, PacketWalk.END);
    }

    /**
     * Adds the blocked parts of the lines, which in lanes without one is all; returns one bit per line that is dimmed.
     */
    static long count(Tile tile, MeshMemory bench) {
        VectorMask<Float> ended = FloatVector.fromArray(Lanes.FLOATS, bench.world.rays, PacketWalk.END)
                .compare(VectorOperators.LT, 0f);
        FloatVector light =
                FloatVector.fromArray(Lanes.FLOATS, bench.light, Lanes.BORDER).blend(0f, ended);
        FloatVector.fromArray(Lanes.FLOATS, bench.blocked, Lanes.BORDER)
                .add(FloatVector.broadcast(Lanes.FLOATS, 1f).sub(light))
                .intoArray(bench.blocked, Lanes.BORDER);
        return light.compare(VectorOperators.LT, 1f).toLong();
    }

    /** One bit per lane in which all samples are blocked. */
    static long hidden(Tile tile, MeshMemory bench, int samples) {
        return FloatVector.fromArray(Lanes.FLOATS, bench.blocked, Lanes.BORDER)
                .compare(VectorOperators.GE, samples)
                .toLong();
    }

    /** Closes the lanes in full shadow, and writes the blocked samples of partly shaded lanes. */
    static void finish(Tile tile, int at, MeshMemory bench, long dark, long part) {
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
                .intoArray(t, at + Tile.MESH_BLOCKED);
    }
}
