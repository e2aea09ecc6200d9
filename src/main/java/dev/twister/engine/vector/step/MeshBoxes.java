package dev.twister.engine.vector.step;

import dev.twister.engine.vector.frame.MeshColumns;
import dev.twister.engine.vector.lanes.Lanes;
import dev.twister.engine.vector.lanes.Tile;
import dev.twister.kernel.NodeBox;
import jdk.incubator.vector.FloatVector;
import jdk.incubator.vector.VectorMask;
import jdk.incubator.vector.VectorOperators;

/** Which rays may meet a mesh before what they have met: {@link NodeBox#entry}. */
public final class MeshBoxes {
    /** Of the distances to a box's sides, what it is grown by: ten times what the rounding of a triangle's test asks. */
    private static final float GROWTH = 1e-5f;

    private MeshBoxes() {}

    /** Mends the hits and distances of the live rays where a mesh's box is closer, or is around the ray's origin. */
    public static void find(Tile tile, MeshColumns meshes) {
        for (int box = 0; box < meshes.boxCount; box++) {
            find(tile, meshes.boxes, MeshColumns.BOX_STRIDE * box, meshes.boxBodies[box]);
        }
    }

    /** No helper is called, for the reason that {@code ShadowConics} has. */
    static void find(Tile tile, float[] boxes, int box, float body) {
        float[] t = tile.values;
        for (int k = 0; k < tile.live.count; k++) {
            int at = tile.live.places[k];
            FloatVector enters = FloatVector.broadcast(Lanes.FLOATS, 0f);
            FloatVector leaves = FloatVector.fromArray(Lanes.FLOATS, t, at + Tile.DISTANCE);
            for (int axis = 0; axis < 3; axis++) {
                FloatVector origin = FloatVector.fromArray(Lanes.FLOATS, t, at + Tile.ORIGIN_X + axis * Tile.SIZE);
                FloatVector direction =
                        FloatVector.fromArray(Lanes.FLOATS, t, at + Tile.DIRECTION_X + axis * Tile.SIZE);
                FloatVector tiny = FloatVector.broadcast(Lanes.FLOATS, NodeBox.TINY);
                FloatVector inverse = FloatVector.broadcast(Lanes.FLOATS, 1f)
                        .div(direction.blend(tiny, direction.abs().compare(VectorOperators.LE, NodeBox.TINY)));
                FloatVector low = FloatVector.broadcast(Lanes.FLOATS, boxes[box + axis])
                        .sub(origin);
                FloatVector high = FloatVector.broadcast(Lanes.FLOATS, boxes[box + 3 + axis])
                        .sub(origin);
                FloatVector growth = low.abs().add(high.abs()).mul(GROWTH);
                VectorMask<Float> falls = inverse.compare(VectorOperators.LT, 0f);
                FloatVector near =
                        low.sub(growth).blend(high.add(growth), falls).mul(inverse);
                FloatVector far =
                        high.add(growth).blend(low.sub(growth), falls).mul(inverse);
                enters = enters.blend(near, near.compare(VectorOperators.GT, enters));
                leaves = leaves.blend(far, far.compare(VectorOperators.LT, leaves));
            }
            VectorMask<Float> met = enters.compare(VectorOperators.LE, leaves);
            FloatVector.fromArray(Lanes.FLOATS, t, at + Tile.DISTANCE)
                    .blend(enters, met)
                    .intoArray(t, at + Tile.DISTANCE);
            FloatVector.fromArray(Lanes.FLOATS, t, at + Tile.HIT)
                    .blend(body, met)
                    .intoArray(t, at + Tile.HIT);
        }
    }
}
