package dev.twister.engine.vector.step;

import dev.twister.engine.vector.frame.Drawing;
import dev.twister.engine.vector.frame.Looks;
import dev.twister.engine.vector.lanes.Lanes;
import dev.twister.engine.vector.lanes.Tile;
import dev.twister.kernel.Layout;
import jdk.incubator.vector.FloatVector;
import jdk.incubator.vector.VectorMask;
import jdk.incubator.vector.VectorOperators;

/** Material properties of surfaces beyond color and reflectivity: {@link dev.twister.kernel.SurfaceLook}. */
public final class MaterialLanes {
    private MaterialLanes() {}

    /** Writes the columns from {@link Tile#ROUGHNESS} on; 0 in lanes without a surface. */
    public static void find(Drawing drawing, Tile tile) {
        if (drawing.bodies.fitLanes()) {
            pick(tile, drawing.looks);
        } else {
            copy(tile, drawing.looks);
        }
        list(tile);
    }

    /** Lists the packets with a rough surface. */
    static void list(Tile tile) {
        tile.rough.clear();
        float[] t = tile.values;
        for (int k = 0; k < tile.surfaces.count; k++) {
            int at = tile.surfaces.places[k];
            if (Lanes.load(t, at + Tile.ROUGHNESS)
                    .compare(VectorOperators.GT, 0f)
                    .anyTrue()) {
                tile.rough.add(at);
            }
        }
    }

    /** For scenes in which one vector holds a column of all bodies. */
    static void pick(Tile tile, Looks looks) {
        float[] t = tile.values;
        float[] columns = looks.columns;
        for (int k = 0; k < tile.surfaces.count; k++) {
            int at = tile.surfaces.places[k];
            FloatVector hit = FloatVector.fromArray(Lanes.FLOATS, t, at + Tile.HIT);
            VectorMask<Float> here = hit.compare(VectorOperators.GE, Layout.PLANE);
            FloatVector body = FloatVector.zero(Lanes.FLOATS).blend(hit, here);
            for (int look = 0; look < Looks.COUNT; look++) {
                FloatVector picked = body.selectFrom(
                        FloatVector.fromArray(Lanes.FLOATS, columns, Lanes.BORDER + look * Lanes.COUNT));
                FloatVector.zero(Lanes.FLOATS).blend(picked, here).intoArray(t, at + Tile.ROUGHNESS + look * Tile.SIZE);
            }
        }
    }

    /** Copies lane by lane. */
    static void copy(Tile tile, Looks looks) {
        float[] t = tile.values;
        float[] values = looks.values;
        for (int k = 0; k < tile.surfaces.count; k++) {
            int at = tile.surfaces.places[k];
            for (int look = 0; look < Looks.COUNT; look++) {
                Lanes.all(0f).intoArray(t, at + Tile.ROUGHNESS + look * Tile.SIZE);
            }
            long rest = Lanes.load(t, at + Tile.HIT)
                    .compare(VectorOperators.GE, Layout.PLANE)
                    .toLong();
            while (rest != 0) {
                int pixel = at + Long.numberOfTrailingZeros(rest);
                int from = Layout.LOOK_STRIDE * (int) t[pixel + Tile.HIT] + Looks.FIRST;
                for (int look = 0; look < Looks.COUNT; look++) {
                    t[pixel + Tile.ROUGHNESS + look * Tile.SIZE] = values[from + look];
                }
                rest &= rest - 1;
            }
        }
    }
}
