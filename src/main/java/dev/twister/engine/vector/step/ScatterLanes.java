package dev.twister.engine.vector.step;

import dev.twister.engine.vector.frame.Drawing;
import dev.twister.engine.vector.frame.ShadingLight;
import dev.twister.engine.vector.lanes.Lanes;
import dev.twister.engine.vector.lanes.Tile;
import dev.twister.kernel.Layout;
import jdk.incubator.vector.FloatVector;
import jdk.incubator.vector.VectorMask;
import jdk.incubator.vector.VectorOperators;

/** Adds the surfaces' reflected light, and reflects the rays that continue. */
public final class ScatterLanes {
    private ScatterLanes() {}

    /**
     * Adds {@code T * (lightColor * spec + (1 - k) * C * lit)} and sets the throughput to {@code T * k * lit}. Lists
     * the packets with a lane that continues as live.
     */
    public static void shade(Tile tile, Drawing drawing) {
        ShadingLight light = drawing.lights[tile.light];
        float ambient = drawing.ambient;
        float[] t = tile.values;
        float lightRed = light.red;
        float lightGreen = light.green;
        float lightBlue = light.blue;
        float mirrorScale = tile.last ? 0f : 1f / Layout.MAX_REFLECTIVITY;
        tile.live.clear();
        for (int k = 0; k < tile.surfaces.count; k++) {
            int at = tile.surfaces.places[k];
            VectorMask<Float> here = Lanes.load(t, at + Tile.HIT).compare(VectorOperators.GE, Layout.PLANE);
            FloatVector throughput = Lanes.all(0f).blend(Lanes.load(t, at + Tile.THROUGHPUT), here);
            // max(0, x) is 0 for NaN, which lanes without a surface may hold: even a throughput of 0 times NaN is NaN.
            FloatVector cosine = Lanes.larger(Lanes.all(0f), Lanes.load(t, at + Tile.NORMAL_DOT_LIGHT));
            FloatVector lit = Lanes.larger(cosine.mul(Lanes.load(t, at + Tile.VISIBLE)), Lanes.all(ambient));
            FloatVector mirror = Lanes.load(t, at + Tile.REFLECTIVITY).mul(mirrorScale);
            FloatVector matte = throughput.mul(Lanes.all(1f).sub(mirror).mul(lit));
            FloatVector specular = throughput.mul(Lanes.load(t, at + Tile.SPECULAR));
            FloatVector red = Lanes.fma(matte, Lanes.load(t, at + Tile.ALBEDO_RED), Lanes.load(t, at + Tile.RED));
            FloatVector green = Lanes.fma(matte, Lanes.load(t, at + Tile.ALBEDO_GREEN), Lanes.load(t, at + Tile.GREEN));
            FloatVector blue = Lanes.fma(matte, Lanes.load(t, at + Tile.ALBEDO_BLUE), Lanes.load(t, at + Tile.BLUE));
            Lanes.fma(specular, Lanes.all(lightRed), red).intoArray(t, at + Tile.RED);
            Lanes.fma(specular, Lanes.all(lightGreen), green).intoArray(t, at + Tile.GREEN);
            Lanes.fma(specular, Lanes.all(lightBlue), blue).intoArray(t, at + Tile.BLUE);
            FloatVector passed = throughput.mul(mirror.mul(lit));
            passed.intoArray(t, at + Tile.THROUGHPUT);
            if (passed.compare(VectorOperators.GT, 0f).anyTrue()) {
                tile.live.add(at);
            }
        }
    }

    /** Reflects the directions of the live rays. */
    public static void reflect(Tile tile) {
        float[] t = tile.values;
        for (int k = 0; k < tile.live.count; k++) {
            int at = tile.live.places[k];
            FloatVector normalX = Lanes.load(t, at + Tile.NORMAL_X);
            FloatVector normalY = Lanes.load(t, at + Tile.NORMAL_Y);
            FloatVector normalZ = Lanes.load(t, at + Tile.NORMAL_Z);
            FloatVector directionX = Lanes.load(t, at + Tile.DIRECTION_X);
            FloatVector directionY = Lanes.load(t, at + Tile.DIRECTION_Y);
            FloatVector directionZ = Lanes.load(t, at + Tile.DIRECTION_Z);
            FloatVector twice = directionX
                    .mul(normalX)
                    .add(directionY.mul(normalY))
                    .add(directionZ.mul(normalZ))
                    .mul(-2f);
            FloatVector x = directionX.add(twice.mul(normalX));
            FloatVector y = directionY.add(twice.mul(normalY));
            FloatVector z = directionZ.add(twice.mul(normalZ));
            FloatVector inverse = Lanes.inverseRoot(x.mul(x).add(y.mul(y)).add(z.mul(z)));
            x.mul(inverse).intoArray(t, at + Tile.DIRECTION_X);
            y.mul(inverse).intoArray(t, at + Tile.DIRECTION_Y);
            z.mul(inverse).intoArray(t, at + Tile.DIRECTION_Z);
        }
    }

    /** Moves the origins of the live rays to the surfaces that they leave. */
    public static void leave(Tile tile) {
        float[] t = tile.values;
        for (int k = 0; k < tile.live.count; k++) {
            int at = tile.live.places[k];
            Lanes.load(t, at + Tile.POINT_X).intoArray(t, at + Tile.ORIGIN_X);
            Lanes.load(t, at + Tile.POINT_Y).intoArray(t, at + Tile.ORIGIN_Y);
            Lanes.load(t, at + Tile.POINT_Z).intoArray(t, at + Tile.ORIGIN_Z);
            Lanes.load(t, at + Tile.HIT).intoArray(t, at + Tile.LEAVING);
        }
    }
}
