package dev.twister.engine.vector.step;

import dev.twister.engine.vector.frame.Drawing;
import dev.twister.engine.vector.lanes.Lanes;
import dev.twister.engine.vector.lanes.Tile;
import dev.twister.kernel.Layout;
import dev.twister.world.View;
import jdk.incubator.vector.FloatVector;

/** Starts one view ray per lane. */
public final class CameraLanes {
    private CameraLanes() {}

    /** Lists the packets that overlap the frame as live; in most tiles these are all. */
    public static void listInside(Tile tile, Drawing drawing) {
        if (tile.left + Tile.SIDE <= drawing.width && tile.top + Tile.SIDE <= drawing.rows) {
            tile.live.addAll();
        } else {
            tile.live.clear();
            for (int at = 0; at < Tile.SIZE; at += Lanes.COUNT) {
                if (tile.left + Tile.column(at) < drawing.width && tile.top + Tile.row(at) < drawing.rows) {
                    tile.live.add(at);
                }
            }
        }
    }

    /** Starts the live rays at the camera or its lens. */
    public static void startRays(Drawing drawing, Tile tile) {
        aim(tile, drawing);
        place(tile, drawing.input.view().frame());
        if (drawing.lens) {
            LensLanes.bend(drawing, tile);
        }
    }

    /** Writes the rays' directions through the current samples. */
    public static void aim(Tile tile, Drawing drawing) {
        float[] camera = drawing.input.view().frame();
        View view = drawing.input.view();
        float step = drawing.viewportStep;
        float left = tile.left;
        float fromLeft = view.sample(tile.sample, 0);
        float middleX = drawing.width * 0.5f;
        float top = drawing.input.firstRow() + tile.top;
        float fromTop = view.sample(tile.sample, 1);
        float middleY = drawing.input.height() * 0.5f;
        float eye = camera[Layout.CAMERA_EYE_DISTANCE];
        float forwardX = eye * camera[Layout.CAMERA_FORWARD];
        float forwardY = eye * camera[Layout.CAMERA_FORWARD + 1];
        float forwardZ = eye * camera[Layout.CAMERA_FORWARD + 2];
        // Loaded once: C2 must assume that each store to a column may change the camera.
        float rightX = camera[Layout.CAMERA_RIGHT];
        float rightY = camera[Layout.CAMERA_RIGHT + 1];
        float rightZ = camera[Layout.CAMERA_RIGHT + 2];
        float upX = camera[Layout.CAMERA_UP];
        float upY = camera[Layout.CAMERA_UP + 1];
        float upZ = camera[Layout.CAMERA_UP + 2];
        float[] t = tile.values;
        for (int k = 0; k < tile.live.count; k++) {
            int at = tile.live.places[k];
            FloatVector x = Lanes.load(t, at + Tile.PLACE_X).add(left).add(fromLeft);
            FloatVector y = Lanes.load(t, at + Tile.PLACE_Y).add(top).add(fromTop);
            FloatVector u = x.sub(middleX).mul(step);
            FloatVector v = Lanes.all(middleY).sub(y).mul(step);
            FloatVector directionX = u.mul(rightX).add(v.mul(upX)).add(forwardX);
            FloatVector directionY = u.mul(rightY).add(v.mul(upY)).add(forwardY);
            FloatVector directionZ = u.mul(rightZ).add(v.mul(upZ)).add(forwardZ);
            FloatVector inverse = Lanes.inverseRoot(
                    directionX.mul(directionX).add(directionY.mul(directionY)).add(directionZ.mul(directionZ)));
            directionX.mul(inverse).intoArray(t, at + Tile.DIRECTION_X);
            directionY.mul(inverse).intoArray(t, at + Tile.DIRECTION_Y);
            directionZ.mul(inverse).intoArray(t, at + Tile.DIRECTION_Z);
        }
    }

    /**
     * One component of a ray's direction through a corner of the tile; the vector is not normalized.
     *
     * @param corner 0 to 3
     * @param axis 0 for x, 1 for y, 2 for z
     */
    public static float corner(Drawing drawing, Tile tile, int corner, int axis) {
        float x = tile.left + corner % 2 * Tile.SIDE - drawing.width * 0.5f;
        float y = drawing.input.height() * 0.5f - (drawing.input.firstRow() + tile.top + corner / 2 * Tile.SIDE);
        return turned(
                x * drawing.viewportStep,
                y * drawing.viewportStep,
                drawing.input.view().frame(),
                axis);
    }

    /** One component of a ray's direction through (u, v) on the viewport; the vector is not normalized. */
    public static float turned(float u, float v, float[] camera, int axis) {
        return u * camera[Layout.CAMERA_RIGHT + axis]
                + v * camera[Layout.CAMERA_UP + axis]
                + camera[Layout.CAMERA_EYE_DISTANCE] * camera[Layout.CAMERA_FORWARD + axis];
    }

    /** Moves all rays to the camera, where they leave no body, with a throughput of 1. */
    public static void place(Tile tile, float[] camera) {
        float x = camera[Layout.CAMERA_POSITION];
        float y = camera[Layout.CAMERA_POSITION + 1];
        float z = camera[Layout.CAMERA_POSITION + 2];
        float[] t = tile.values;
        for (int k = 0; k < tile.live.count; k++) {
            int at = tile.live.places[k];
            Lanes.all(x).intoArray(t, at + Tile.ORIGIN_X);
            Lanes.all(y).intoArray(t, at + Tile.ORIGIN_Y);
            Lanes.all(z).intoArray(t, at + Tile.ORIGIN_Z);
            Lanes.all(Layout.NOTHING).intoArray(t, at + Tile.LEAVING);
            Lanes.all(1f).intoArray(t, at + Tile.THROUGHPUT);
        }
    }

    /** Sets the lanes' colors to black. */
    public static void blacken(Tile tile) {
        float[] t = tile.values;
        for (int k = 0; k < tile.live.count; k++) {
            int at = tile.live.places[k];
            Lanes.all(0f).intoArray(t, at + Tile.RED);
            Lanes.all(0f).intoArray(t, at + Tile.GREEN);
            Lanes.all(0f).intoArray(t, at + Tile.BLUE);
        }
    }
}
