package dev.twister.engine.vector.step;

import dev.twister.engine.vector.frame.Drawing;
import dev.twister.engine.vector.lanes.Lanes;
import dev.twister.engine.vector.lanes.Sine;
import dev.twister.engine.vector.lanes.Tile;
import dev.twister.kernel.Layout;
import jdk.incubator.vector.FloatVector;
import jdk.incubator.vector.VectorOperators;

/** View rays through the lens: {@link dev.twister.kernel.Lens}. */
final class LensLanes {
    /** Offset in turns that makes a sine a cosine. */
    private static final float COSINE = 0.25f;

    private LensLanes() {}

    /** Moves the live view rays from the pinhole to points of the lens, and turns them to the plane in focus. */
    static void bend(Drawing drawing, Tile tile) {
        float[] frame = drawing.input.view().frame();
        NumberLanes.find(tile, drawing, tile.live, Layout.SAMPLE_LENS, Tile.FIRST_NUMBER);
        NumberLanes.find(tile, drawing, tile.live, Layout.SAMPLE_LENS + 1, Tile.SECOND_NUMBER);
        spread(tile, frame[Layout.CAMERA_APERTURE], COSINE, Tile.LENS_RIGHT);
        spread(tile, frame[Layout.CAMERA_APERTURE], 0f, Tile.LENS_UP);
        findDistances(tile, frame);
        for (int axis = 0; axis < 3; axis++) {
            move(tile, frame, axis);
        }
        normalize(tile);
    }

    /** Writes one coordinate of the points on the lens, in meters. */
    static void spread(Tile tile, float aperture, float turn, int column) {
        float[] t = tile.values;
        for (int k = 0; k < tile.live.count; k++) {
            int at = tile.live.places[k];
            FloatVector radius = Lanes.load(t, at + Tile.FIRST_NUMBER).sqrt().mul(aperture);
            FloatVector turns = Lanes.load(t, at + Tile.SECOND_NUMBER).add(turn);
            FloatVector sine = Sine.ofTurns(turns.blend(turns.sub(1f), turns.compare(VectorOperators.GE, 1f)));
            radius.mul(sine).intoArray(t, at + column);
        }
    }

    /** Writes the distances to the plane in focus along the pinhole's rays. */
    static void findDistances(Tile tile, float[] frame) {
        float[] t = tile.values;
        float focus = frame[Layout.CAMERA_FOCUS];
        float x = frame[Layout.CAMERA_FORWARD];
        float y = frame[Layout.CAMERA_FORWARD + 1];
        float z = frame[Layout.CAMERA_FORWARD + 2];
        for (int k = 0; k < tile.live.count; k++) {
            int at = tile.live.places[k];
            FloatVector ahead = Lanes.load(t, at + Tile.DIRECTION_X)
                    .mul(x)
                    .add(Lanes.load(t, at + Tile.DIRECTION_Y).mul(y))
                    .add(Lanes.load(t, at + Tile.DIRECTION_Z).mul(z));
            Lanes.all(focus).div(ahead).intoArray(t, at + Tile.DISTANCE);
        }
    }

    /** Writes one component of the origins and of the directions, which have any length. */
    static void move(Tile tile, float[] frame, int axis) {
        float[] t = tile.values;
        float position = frame[Layout.CAMERA_POSITION + axis];
        float right = frame[Layout.CAMERA_RIGHT + axis];
        float up = frame[Layout.CAMERA_UP + axis];
        for (int k = 0; k < tile.live.count; k++) {
            int at = tile.live.places[k];
            int component = at + axis * Tile.SIZE;
            FloatVector away = Lanes.load(t, at + Tile.LENS_RIGHT)
                    .mul(right)
                    .add(Lanes.load(t, at + Tile.LENS_UP).mul(up));
            away.add(position).intoArray(t, component + Tile.ORIGIN_X);
            Lanes.load(t, at + Tile.DISTANCE)
                    .mul(Lanes.load(t, component + Tile.DIRECTION_X))
                    .sub(away)
                    .intoArray(t, component + Tile.DIRECTION_X);
        }
    }

    static void normalize(Tile tile) {
        float[] t = tile.values;
        for (int k = 0; k < tile.live.count; k++) {
            int at = tile.live.places[k];
            FloatVector x = Lanes.load(t, at + Tile.DIRECTION_X);
            FloatVector y = Lanes.load(t, at + Tile.DIRECTION_Y);
            FloatVector z = Lanes.load(t, at + Tile.DIRECTION_Z);
            FloatVector inverse = Lanes.inverseRoot(x.mul(x).add(y.mul(y)).add(z.mul(z)));
            x.mul(inverse).intoArray(t, at + Tile.DIRECTION_X);
            y.mul(inverse).intoArray(t, at + Tile.DIRECTION_Y);
            z.mul(inverse).intoArray(t, at + Tile.DIRECTION_Z);
        }
    }
}
