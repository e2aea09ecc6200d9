package dev.twister.gui.picking;

import dev.twister.kernel.Layout;
import dev.twister.scene.Vector3;
import dev.twister.world.FrameInput;

/** Where points of the scene are in a picture, by the inverse of what {@link dev.twister.kernel.CameraRay} does. */
public final class Projection {
    /** Meters before the camera from which on a line is seen. */
    private static final double NEAREST = 1e-3;

    private final float[] camera;
    private final Vector3 origin;
    private final int width;
    private final int height;

    private Projection(FrameInput input) {
        camera = input.view().frame();
        origin = input.bodies().origin();
        width = input.width();
        height = input.height();
    }

    public static Projection of(FrameInput input) {
        return new Projection(input);
    }

    /** The camera's position in the scene. */
    Vector3 viewpoint() {
        return new Vector3(
                origin.x() + camera[Layout.CAMERA_POSITION],
                origin.y() + camera[Layout.CAMERA_POSITION + 1],
                origin.z() + camera[Layout.CAMERA_POSITION + 2]);
    }

    /** The unit vector to the right of the picture. */
    Vector3 right() {
        return new Vector3(
                camera[Layout.CAMERA_RIGHT], camera[Layout.CAMERA_RIGHT + 1], camera[Layout.CAMERA_RIGHT + 2]);
    }

    /** x and y of a point, in pixels from the upper left corner; empty if it is behind the camera. */
    public double[] point(Vector3 place) {
        double[] seen = seen(place);
        return seen[2] < NEAREST ? new double[0] : pixel(seen);
    }

    /** What a meter across the view comes to at a place before the camera. */
    double pixelsPerMeter(Vector3 place) {
        return camera[Layout.CAMERA_EYE_DISTANCE] / seen(place)[2] * Math.min(width, height) / 2;
    }

    /** x and y of both ends of a line's visible part; empty if it is behind the camera. */
    public double[] line(Vector3 from, Vector3 to) {
        double[] start = seen(from);
        double[] end = seen(to);
        if (start[2] < NEAREST && end[2] < NEAREST) {
            return new double[0];
        }
        double[] first = pixel(start[2] < NEAREST ? cut(end, start) : start);
        double[] last = pixel(end[2] < NEAREST ? cut(start, end) : end);
        return new double[] {first[0], first[1], last[0], last[1]};
    }

    /** The inverse of {@link dev.twister.kernel.CameraRay#u}. */
    private static double x(double u, int width, int height) {
        return width > height ? (u + 1) / 2 * height + (width - height) / 2.0 : (u + 1) / 2 * width;
    }

    /** The inverse of {@link dev.twister.kernel.CameraRay#v}. */
    private static double y(double v, int width, int height) {
        return width > height ? (1 - v) / 2 * height : (1 - v) / 2 * width + (height - width) / 2.0;
    }

    private static double[] cut(double[] before, double[] behind) {
        double share = (before[2] - NEAREST) / (before[2] - behind[2]);
        double[] cut = new double[3];
        for (int axis = 0; axis < 3; axis++) {
            cut[axis] = before[axis] + share * (behind[axis] - before[axis]);
        }
        return cut;
    }

    private double[] pixel(double[] seen) {
        double scale = camera[Layout.CAMERA_EYE_DISTANCE] / seen[2];
        return new double[] {x(scale * seen[0], width, height), y(scale * seen[1], width, height)};
    }

    /** To the right, up and forward from the camera. */
    private double[] seen(Vector3 place) {
        double[] away = {
            place.x() - origin.x() - camera[Layout.CAMERA_POSITION],
            place.y() - origin.y() - camera[Layout.CAMERA_POSITION + 1],
            place.z() - origin.z() - camera[Layout.CAMERA_POSITION + 2]
        };
        return new double[] {
            along(Layout.CAMERA_RIGHT, away), along(Layout.CAMERA_UP, away), along(Layout.CAMERA_FORWARD, away)
        };
    }

    private double along(int axisOfCamera, double[] away) {
        return away[0] * camera[axisOfCamera] + away[1] * camera[axisOfCamera + 1] + away[2] * camera[axisOfCamera + 2];
    }
}
