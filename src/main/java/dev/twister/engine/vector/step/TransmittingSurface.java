package dev.twister.engine.vector.step;

import dev.twister.engine.vector.lanes.Lanes;
import dev.twister.engine.vector.lanes.Tile;
import dev.twister.kernel.Layout;
import jdk.incubator.vector.FloatVector;
import jdk.incubator.vector.VectorMask;
import jdk.incubator.vector.VectorOperators;

/** Changes to transmitting surfaces before shading: {@link dev.twister.kernel.Surface}. */
public final class TransmittingSurface {
    private TransmittingSurface() {}

    /**
     * Turns the normals of spheres that are hit from inside, removes the transmitted part from the albedo, and lists
     * the packets with transmitting surfaces. At the last bounce the transmission is 0.
     *
     * @param firstMesh the first mesh's body; above all bodies if there are no meshes
     */
    public static void face(Tile tile, int firstMesh) {
        tile.transparent.clear();
        float[] t = tile.values;
        float notLast = tile.last ? 0f : 1f;
        for (int k = 0; k < tile.surfaces.count; k++) {
            int at = tile.surfaces.places[k];
            FloatVector hit = Lanes.load(t, at + Tile.HIT);
            FloatVector x = Lanes.load(t, at + Tile.NORMAL_X);
            FloatVector y = Lanes.load(t, at + Tile.NORMAL_Y);
            FloatVector z = Lanes.load(t, at + Tile.NORMAL_Z);
            FloatVector transmission = Lanes.load(t, at + Tile.TRANSMISSION);
            VectorMask<Float> transmits = transmission.compare(VectorOperators.GT, 0f);
            VectorMask<Float> mesh = hit.compare(VectorOperators.GE, firstMesh);
            FloatVector along = Lanes.load(t, at + Tile.DIRECTION_X)
                    .mul(x.blend(Lanes.load(t, at + Tile.FACE_X), mesh))
                    .add(Lanes.load(t, at + Tile.DIRECTION_Y).mul(y.blend(Lanes.load(t, at + Tile.FACE_Y), mesh)))
                    .add(Lanes.load(t, at + Tile.DIRECTION_Z).mul(z.blend(Lanes.load(t, at + Tile.FACE_Z), mesh)));
            VectorMask<Float> inside = along.compare(VectorOperators.GT, 0f)
                    .and(hit.compare(VectorOperators.GT, Layout.PLANE))
                    .and(transmits);
            VectorMask<Float> turned = inside.andNot(mesh);
            x.blend(x.neg(), turned).intoArray(t, at + Tile.NORMAL_X);
            y.blend(y.neg(), turned).intoArray(t, at + Tile.NORMAL_Y);
            z.blend(z.neg(), turned).intoArray(t, at + Tile.NORMAL_Z);
            Lanes.all(0f).blend(1f, inside).intoArray(t, at + Tile.FROM_INSIDE);
            Lanes.all(0f)
                    .blend(Lanes.load(t, at + Tile.THROUGHPUT), hit.compare(VectorOperators.GE, Layout.PLANE))
                    .intoArray(t, at + Tile.WHOLE);
            FloatVector now = transmission.mul(notLast);
            now.intoArray(t, at + Tile.TRANSMISSION);
            FloatVector kept = Lanes.all(1f).sub(now);
            FloatVector red = Lanes.load(t, at + Tile.ALBEDO_RED);
            FloatVector green = Lanes.load(t, at + Tile.ALBEDO_GREEN);
            FloatVector blue = Lanes.load(t, at + Tile.ALBEDO_BLUE);
            red.intoArray(t, at + Tile.PASSED_RED);
            green.intoArray(t, at + Tile.PASSED_GREEN);
            blue.intoArray(t, at + Tile.PASSED_BLUE);
            red.mul(kept).intoArray(t, at + Tile.ALBEDO_RED);
            green.mul(kept).intoArray(t, at + Tile.ALBEDO_GREEN);
            blue.mul(kept).intoArray(t, at + Tile.ALBEDO_BLUE);
            if (transmits.anyTrue()) {
                tile.transparent.add(at);
            }
        }
    }

    /** Closes the lanes of perfectly clear glass, whose color does not depend on shadows. */
    public static void leaveInTheLight(Tile tile) {
        float[] t = tile.values;
        int kept = 0;
        for (int k = 0; k < tile.shadows.count; k++) {
            int at = tile.shadows.places[k];
            VectorMask<Float> clear = Lanes.load(t, at + Tile.TRANSMISSION)
                    .compare(VectorOperators.GE, 1f)
                    .and(Lanes.load(t, at + Tile.REFLECTIVITY).compare(VectorOperators.LE, 0f));
            FloatVector open = Lanes.load(t, at + Tile.SHADOW_OPEN).blend(0f, clear);
            open.intoArray(t, at + Tile.SHADOW_OPEN);
            if (open.compare(VectorOperators.GT, 0f).anyTrue()) {
                tile.shadows.places[kept] = at;
                kept++;
            }
        }
        tile.shadows.count = kept;
    }
}
