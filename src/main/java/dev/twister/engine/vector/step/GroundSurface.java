package dev.twister.engine.vector.step;

import dev.twister.engine.vector.frame.BodyColumns;
import dev.twister.engine.vector.frame.Drawing;
import dev.twister.engine.vector.lanes.Lanes;
import dev.twister.engine.vector.lanes.Tile;
import dev.twister.kernel.Layout;
import dev.twister.kernel.SurfaceLook;
import jdk.incubator.vector.FloatVector;
import jdk.incubator.vector.VectorMask;
import jdk.incubator.vector.VectorOperators;

/** Surface data of the plane: points, normals and checker colors, written to all lanes of a packet. */
public final class GroundSurface {
    private GroundSurface() {}

    public static void find(Drawing drawing, Tile tile) {
        findPoints(tile, drawing);
        findColors(tile, drawing);
    }

    static void findPoints(Tile tile, Drawing drawing) {
        float[] t = tile.values;
        for (int k = 0; k < tile.grounds.count; k++) {
            int at = tile.grounds.places[k];
            // The other lanes use distance 0: a miss's distance would produce NaN.
            FloatVector distance = Lanes.all(0f)
                    .blend(
                            Lanes.load(t, at + Tile.DISTANCE),
                            Lanes.load(t, at + Tile.HIT).compare(VectorOperators.EQ, Layout.PLANE));
            Lanes.load(t, at + Tile.ORIGIN_X)
                    .add(distance.mul(Lanes.load(t, at + Tile.DIRECTION_X)))
                    .intoArray(t, at + Tile.POINT_X);
            Lanes.all(drawing.planeHeight).intoArray(t, at + Tile.POINT_Y);
            Lanes.load(t, at + Tile.ORIGIN_Z)
                    .add(distance.mul(Lanes.load(t, at + Tile.DIRECTION_Z)))
                    .intoArray(t, at + Tile.POINT_Z);
            Lanes.all(0f).intoArray(t, at + Tile.NORMAL_X);
            Lanes.all(1f).intoArray(t, at + Tile.NORMAL_Y);
            Lanes.all(0f).intoArray(t, at + Tile.NORMAL_Z);
        }
    }

    public static void findColors(Tile tile, Drawing drawing) {
        float[] t = tile.values;
        float[] values = drawing.input.view().frame();
        BodyColumns bodies = drawing.bodies;
        float red = bodies.red(Layout.PLANE);
        float green = bodies.green(Layout.PLANE);
        float blue = bodies.blue(Layout.PLANE);
        float reflectivity = bodies.reflectivity(Layout.PLANE);
        float oddRed = values[Layout.PLANE_ODD_COLOR];
        float oddGreen = values[Layout.PLANE_ODD_COLOR + 1];
        float oddBlue = values[Layout.PLANE_ODD_COLOR + 2];
        for (int k = 0; k < tile.grounds.count; k++) {
            int at = tile.grounds.places[k];
            FloatVector squares = Lanes.floor(Lanes.load(t, at + Tile.POINT_X).add(SurfaceLook.CHECKER_SHIFT))
                    .add(Lanes.floor(Lanes.load(t, at + Tile.POINT_Z).add(SurfaceLook.CHECKER_SHIFT)));
            FloatVector pairs = Lanes.floor(squares.mul(0.5f));
            VectorMask<Float> odd = pairs.add(pairs).compare(VectorOperators.NE, squares);
            Lanes.all(red).blend(oddRed, odd).intoArray(t, at + Tile.ALBEDO_RED);
            Lanes.all(green).blend(oddGreen, odd).intoArray(t, at + Tile.ALBEDO_GREEN);
            Lanes.all(blue).blend(oddBlue, odd).intoArray(t, at + Tile.ALBEDO_BLUE);
            Lanes.all(reflectivity).intoArray(t, at + Tile.REFLECTIVITY);
        }
    }
}
