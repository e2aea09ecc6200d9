package dev.twister.engine.vector.step;

import dev.twister.engine.vector.frame.Drawing;
import dev.twister.engine.vector.frame.ShadingLight;
import dev.twister.engine.vector.lanes.Lanes;
import dev.twister.engine.vector.lanes.Tile;
import dev.twister.kernel.Layout;
import jdk.incubator.vector.FloatVector;
import jdk.incubator.vector.VectorMask;
import jdk.incubator.vector.VectorOperators;

/** Direction of the light that shades from the surfaces, and the points where a shadow would be visible. */
public final class LightDirection {
    private LightDirection() {}

    /** Writes direction and distance of the light, and lists the packets where shadows would be visible. */
    public static void find(Drawing drawing, Tile tile) {
        findDirections(tile, drawing.lights[tile.light]);
        sort(tile, drawing.severalLights ? 0f : drawing.ambient);
    }

    /** Writes the unit vectors to the light, the distances, and the cosines with the normals. */
    static void findDirections(Tile tile, ShadingLight light) {
        float lightX = light.x;
        float lightY = light.y;
        float lightZ = light.z;
        float[] t = tile.values;
        for (int k = 0; k < tile.surfaces.count; k++) {
            int at = tile.surfaces.places[k];
            FloatVector x = Lanes.all(lightX).sub(Lanes.load(t, at + Tile.POINT_X));
            FloatVector y = Lanes.all(lightY).sub(Lanes.load(t, at + Tile.POINT_Y));
            FloatVector z = Lanes.all(lightZ).sub(Lanes.load(t, at + Tile.POINT_Z));
            FloatVector squared = x.mul(x).add(y.mul(y)).add(z.mul(z));
            FloatVector inverse = Lanes.inverseRoot(squared);
            FloatVector unitX = x.mul(inverse);
            FloatVector unitY = y.mul(inverse);
            FloatVector unitZ = z.mul(inverse);
            unitX.intoArray(t, at + Tile.TO_LIGHT_X);
            unitY.intoArray(t, at + Tile.TO_LIGHT_Y);
            unitZ.intoArray(t, at + Tile.TO_LIGHT_Z);
            squared.mul(inverse).intoArray(t, at + Tile.LIGHT_DISTANCE);
            unitX.mul(Lanes.load(t, at + Tile.NORMAL_X))
                    .add(unitY.mul(Lanes.load(t, at + Tile.NORMAL_Y)))
                    .add(unitZ.mul(Lanes.load(t, at + Tile.NORMAL_Z)))
                    .intoArray(t, at + Tile.NORMAL_DOT_LIGHT);
        }
    }

    /** Sets the visible part to 1, and lists the packets with lanes where a shadow would be visible. */
    public static void sort(Tile tile, float ambient) {
        tile.shadows.clear();
        float[] t = tile.values;
        for (int k = 0; k < tile.surfaces.count; k++) {
            int at = tile.surfaces.places[k];
            FloatVector cosine = Lanes.load(t, at + Tile.NORMAL_DOT_LIGHT);
            VectorMask<Float> glossy = Lanes.load(t, at + Tile.REFLECTIVITY).compare(VectorOperators.GT, 0f);
            VectorMask<Float> open = cosine.compare(VectorOperators.GT, ambient)
                    .or(cosine.compare(VectorOperators.GT, 0f).and(glossy))
                    .and(Lanes.load(t, at + Tile.HIT).compare(VectorOperators.GE, Layout.PLANE));
            Lanes.all(1f).intoArray(t, at + Tile.VISIBLE);
            Lanes.all(0f).blend(1f, open).intoArray(t, at + Tile.SHADOW_OPEN);
            if (open.anyTrue()) {
                tile.shadows.add(at);
            }
        }
    }
}
