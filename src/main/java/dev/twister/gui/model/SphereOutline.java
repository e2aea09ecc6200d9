package dev.twister.gui.model;

import dev.twister.kernel.Layout;
import dev.twister.world.FrameInput;

/** The line around a sphere as it is seen: an ellipse, for a sphere that is not in the middle of the picture. */
public final class SphereOutline {
    private SphereOutline() {}

    /**
     * Corners of a polygon around a sphere or the light: x and y of each in turn, in pixels of the picture. Empty where
     * some of the outline lies behind the camera, or the camera in the sphere.
     *
     * <p>The rays that touch the sphere, with center C at distance d from the camera and radius r, do so on a circle
     * about {@code C - C / |C| * r^2 / d} of radius {@code r * sqrt(1 - r^2 / d^2)}, in a plane across the line to the
     * center.
     */
    public static double[] corners(FrameInput input, int body, int count) {
        float[] camera = input.view().frame();
        double radius = input.bodies().size(body);
        double[] center = new double[3];
        for (int axis = 0; axis < 3; axis++) {
            center[axis] = input.bodies().center(body, axis) - camera[Layout.CAMERA_POSITION + axis];
        }
        double distance = Math.sqrt(dot(center, center));
        if (distance <= radius) {
            return new double[0];
        }
        double[] sight = scaled(center, 1 / distance);
        double[] across = perpendicular(sight);
        double[] along = cross(sight, across);
        double sine = radius / distance;
        double toPlane = distance * (1 - sine * sine);
        double circle = radius * Math.sqrt(1 - sine * sine);
        double[] corners = new double[2 * count];
        for (int i = 0; i < count; i++) {
            double angle = 2 * Math.PI * i / count;
            double[] point = new double[3];
            for (int axis = 0; axis < 3; axis++) {
                point[axis] = toPlane * sight[axis]
                        + circle * (Math.cos(angle) * across[axis] + Math.sin(angle) * along[axis]);
            }
            double depth = along(camera, Layout.CAMERA_FORWARD, point);
            if (depth <= 0) {
                return new double[0];
            }
            double scale = camera[Layout.CAMERA_EYE_DISTANCE] / depth;
            corners[2 * i] =
                    Projection.x(scale * along(camera, Layout.CAMERA_RIGHT, point), input.width(), input.height());
            corners[2 * i + 1] =
                    Projection.y(scale * along(camera, Layout.CAMERA_UP, point), input.width(), input.height());
        }
        return corners;
    }

    private static double along(float[] camera, int axisOfCamera, double[] point) {
        return point[0] * camera[axisOfCamera]
                + point[1] * camera[axisOfCamera + 1]
                + point[2] * camera[axisOfCamera + 2];
    }

    private static double[] perpendicular(double[] unit) {
        double[] other = Math.abs(unit[0]) < 0.5 ? new double[] {1, 0, 0} : new double[] {0, 1, 0};
        double[] across = cross(unit, other);
        return scaled(across, 1 / Math.sqrt(dot(across, across)));
    }

    private static double[] cross(double[] a, double[] b) {
        return new double[] {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
    }

    private static double dot(double[] a, double[] b) {
        return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    }

    private static double[] scaled(double[] a, double factor) {
        return new double[] {factor * a[0], factor * a[1], factor * a[2]};
    }
}
