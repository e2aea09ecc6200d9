package dev.twister.gui.picking;

import dev.twister.kernel.CameraRay;
import dev.twister.kernel.Layout;
import dev.twister.scene.Vector3;
import dev.twister.world.FrameInput;

/** Where points of the scene are in a picture, by the inverse of what {@link CameraRay} does. */
public final class Projection {
    /** Meters before the camera from which on a line is seen. */
    private static final double NEAREST = 1e-3;

    /** Meters, beside which what is seen is small. */
    private static final double FAR_METERS = 1e6;

    private final int kind;
    private final float[] camera;
    private final Vector3 origin;
    private final int width;
    private final int height;

    private Projection(FrameInput input) {
        camera = input.view().frame();
        kind = (int) camera[Layout.CAMERA_PROJECTION];
        origin = input.bodies().origin();
        width = input.width();
        height = input.height();
    }

    public static Projection of(FrameInput input) {
        return new Projection(input);
    }

    /** The point in the scene to which view rays come together; far behind the camera where they are parallel. */
    Vector3 viewpoint() {
        double behind = kind == CameraRay.ORTHOGRAPHIC ? FAR_METERS : 0;
        return new Vector3(
                origin.x() + camera[Layout.CAMERA_POSITION] - behind * camera[Layout.CAMERA_FORWARD],
                origin.y() + camera[Layout.CAMERA_POSITION + 1] - behind * camera[Layout.CAMERA_FORWARD + 1],
                origin.z() + camera[Layout.CAMERA_POSITION + 2] - behind * camera[Layout.CAMERA_FORWARD + 2]);
    }

    /** The unit vector to the right of the picture. */
    Vector3 right() {
        return new Vector3(
                camera[Layout.CAMERA_RIGHT], camera[Layout.CAMERA_RIGHT + 1], camera[Layout.CAMERA_RIGHT + 2]);
    }

    /** x and y of a point, in pixels from the upper left corner; empty if it is behind the camera. */
    public double[] point(Vector3 place) {
        double[] seen = seen(place);
        return isBehind(seen) ? new double[0] : pixel(seen);
    }

    /** Meters along the view ray to a point. */
    public double distance(Vector3 place) {
        double[] seen = seen(place);
        return kind == CameraRay.ORTHOGRAPHIC ? seen[2] : length(seen);
    }

    /** What a meter across the view comes to at a place before the camera. */
    public double pixelsPerMeter(Vector3 place) {
        double[] seen = seen(place);
        return switch (kind) {
            case CameraRay.PERSPECTIVE -> camera[Layout.CAMERA_EYE_DISTANCE] / seen[2] * Math.min(width, height) / 2;
            case CameraRay.ORTHOGRAPHIC -> height / camera[Layout.CAMERA_VIEW_HEIGHT];
            case CameraRay.PANORAMA -> height / (Math.PI * length(seen));
            default -> Math.min(width, height) / 2.0 / (halfField() * length(seen));
        };
    }

    /**
     * x and y of both ends of a line's visible part; empty if it is behind the camera, or goes over a panorama's
     * border.
     */
    public double[] line(Vector3 from, Vector3 to) {
        double[] start = seen(from);
        double[] end = seen(to);
        if (isBehind(start) && isBehind(end)) {
            return new double[0];
        }
        double[] first = pixel(isBehind(start) ? cut(end, start) : start);
        double[] last = pixel(isBehind(end) ? cut(start, end) : end);
        boolean overTheBorder = kind == CameraRay.PANORAMA && Math.abs(first[0] - last[0]) > width / 2.0;
        return overTheBorder ? new double[0] : new double[] {first[0], first[1], last[0], last[1]};
    }

    private boolean isBehind(double[] seen) {
        return kind <= CameraRay.ORTHOGRAPHIC && seen[2] < NEAREST;
    }

    /** Half the angle of a fisheye over the shorter side, in radians. */
    private double halfField() {
        return 2 * Math.PI * camera[Layout.CAMERA_HALF_FIELD];
    }

    private static double length(double[] seen) {
        return Math.max(NEAREST, Math.hypot(Math.hypot(seen[0], seen[1]), seen[2]));
    }

    /** The inverse of {@link CameraRay#u}. */
    private static double x(double u, int width, int height) {
        return width > height ? (u + 1) / 2 * height + (width - height) / 2.0 : (u + 1) / 2 * width;
    }

    /** The inverse of {@link CameraRay#v}. */
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
        double across = Math.hypot(seen[0], seen[1]);
        return switch (kind) {
            case CameraRay.PERSPECTIVE -> pixel(seen, camera[Layout.CAMERA_EYE_DISTANCE] / seen[2]);
            case CameraRay.ORTHOGRAPHIC -> {
                double scale = height / camera[Layout.CAMERA_VIEW_HEIGHT];
                yield new double[] {width / 2.0 + scale * seen[0], height / 2.0 - scale * seen[1]};
            }
            case CameraRay.PANORAMA ->
                new double[] {
                    (0.5 + Math.atan2(seen[0], seen[2]) / (2 * Math.PI)) * width,
                    (0.5 - Math.atan2(seen[1], Math.hypot(seen[0], seen[2])) / Math.PI) * height
                };
            default -> pixel(seen, across == 0 ? 0 : Math.atan2(across, seen[2]) / halfField() / across);
        };
    }

    private double[] pixel(double[] seen, double scale) {
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
