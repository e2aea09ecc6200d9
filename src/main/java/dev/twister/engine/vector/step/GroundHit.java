package dev.twister.engine.vector.step;

import dev.twister.engine.vector.frame.Drawing;
import dev.twister.engine.vector.lanes.Lanes;
import dev.twister.engine.vector.lanes.Tile;
import dev.twister.kernel.Layout;
import jdk.incubator.vector.FloatVector;
import jdk.incubator.vector.VectorMask;
import jdk.incubator.vector.VectorOperators;

/** Whether the plane is hit before any sphere: {@link dev.twister.kernel.Intersection#plane}. */
public final class GroundHit {
    private GroundHit() {}

    /**
     * Replaces hits and distances where the plane is closer. A level ray's distance is infinite or NaN and fails every
     * comparison.
     */
    public static void find(Tile tile, Drawing drawing) {
        float height = drawing.planeHeight;
        float halfSide = drawing.planeHalfSide;
        float centerX = drawing.planeX;
        float centerZ = drawing.planeZ;
        float[] t = tile.values;
        for (int k = 0; k < tile.live.count; k++) {
            int at = tile.live.places[k];
            FloatVector along =
                    Lanes.all(height).sub(Lanes.load(t, at + Tile.ORIGIN_Y)).div(Lanes.load(t, at + Tile.DIRECTION_Y));
            FloatVector x = Lanes.load(t, at + Tile.ORIGIN_X).add(along.mul(Lanes.load(t, at + Tile.DIRECTION_X)));
            FloatVector z = Lanes.load(t, at + Tile.ORIGIN_Z).add(along.mul(Lanes.load(t, at + Tile.DIRECTION_Z)));
            FloatVector closest = Lanes.load(t, at + Tile.DISTANCE);
            FloatVector hit = Lanes.load(t, at + Tile.HIT);
            VectorMask<Float> tie =
                    along.compare(VectorOperators.EQ, closest).and(hit.compare(VectorOperators.GT, Layout.PLANE));
            VectorMask<Float> met = along.compare(VectorOperators.LT, closest)
                    .or(tie)
                    .and(along.compare(VectorOperators.GT, 0f))
                    .and(x.sub(centerX).abs().compare(VectorOperators.LE, halfSide))
                    .and(z.sub(centerZ).abs().compare(VectorOperators.LE, halfSide))
                    .and(Lanes.load(t, at + Tile.LEAVING).compare(VectorOperators.NE, Layout.PLANE));
            closest.blend(along, met).intoArray(t, at + Tile.DISTANCE);
            hit.blend(Layout.PLANE, met).intoArray(t, at + Tile.HIT);
        }
    }
}
