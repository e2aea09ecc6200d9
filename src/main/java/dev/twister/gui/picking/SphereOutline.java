package dev.twister.gui.picking;

import dev.twister.scene.Vector3;
import dev.twister.world.FrameInput;

/** The outline of a sphere in a picture, which is an ellipse unless the sphere is in the middle. */
public final class SphereOutline {
    private static final double[] NONE = {};

    private SphereOutline() {}

    /**
     * Corners of a polygon around a sphere or the light: x and y of each in turn, in pixels of the picture. Empty if
     * part of the outline is behind the camera, or the camera is in the sphere.
     *
     * <p>The rays that touch the sphere, with center C at distance d from the camera and radius r, do so on a circle
     * about {@code C - C / |C| * r^2 / d} of radius {@code r * sqrt(1 - r^2 / d^2)}, in a plane across the line to the
     * center.
     */
    public static double[] corners(FrameInput input, int body, int count) {
        Projection projection = Projection.of(input);
        Vector3 viewpoint = projection.viewpoint();
        Vector3 away = input.bodies().centerInScene(body).minus(viewpoint);
        double radius = input.bodies().size(body);
        double distance = away.length();
        if (distance <= radius) {
            return NONE;
        }
        Vector3 sight = away.times(1 / distance);
        Vector3 across = sight.cross(Math.abs(sight.x()) < 0.5 ? new Vector3(1, 0, 0) : new Vector3(0, 1, 0))
                .normalized();
        Vector3 along = sight.cross(across);
        double sine = radius / distance;
        Vector3 middle = viewpoint.plus(sight.times(distance * (1 - sine * sine)));
        double circle = radius * Math.sqrt(1 - sine * sine);
        double[] corners = new double[2 * count];
        for (int i = 0; i < count; i++) {
            double angle = 2 * Math.PI * i / count;
            double[] corner = projection.point(
                    middle.plus(across.times(circle * Math.cos(angle))).plus(along.times(circle * Math.sin(angle))));
            if (corner.length == 0) {
                return NONE;
            }
            corners[2 * i] = corner[0];
            corners[2 * i + 1] = corner[1];
        }
        return corners;
    }
}
