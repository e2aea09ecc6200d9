package dev.twister.gui.picking;

import dev.twister.scene.Vector3;
import dev.twister.world.FrameInput;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;

/** Outlines of bodies in the picture: a sphere's ellipse, and the convex hull of a mesh's projected points. */
public final class BodyOutline {
    private static final double[] NONE = {};

    private BodyOutline() {}

    /**
     * Corners of a polygon around a mesh: x and y of each in turn, in pixels of the picture. Empty if a point lies
     * behind the camera.
     *
     * @param farPoints of the mesh, as {@link dev.twister.world.SceneMeshes#farPoints} has them
     */
    public static double[] ofMesh(FrameInput input, List<Vector3> farPoints) {
        Projection projection = Projection.of(input);
        List<double[]> seen = new ArrayList<>();
        for (Vector3 point : farPoints) {
            double[] pixel = projection.point(point);
            if (pixel.length == 0) {
                return new double[0];
            }
            seen.add(pixel);
        }
        seen.sort(Comparator.<double[]>comparingDouble(pixel -> pixel[0]).thenComparingDouble(pixel -> pixel[1]));
        List<double[]> hull = new ArrayList<>(chain(seen));
        hull.addAll(chain(seen.reversed()));
        return hull.stream().flatMapToDouble(Arrays::stream).toArray();
    }

    /** One side of the hull, by Andrew's monotone chain, without its last point, which begins the other side. */
    private static List<double[]> chain(List<double[]> sorted) {
        List<double[]> side = new ArrayList<>();
        for (double[] pixel : sorted) {
            while (side.size() > 1 && !turnsLeft(side.get(side.size() - 2), side.getLast(), pixel)) {
                side.removeLast();
            }
            side.add(pixel);
        }
        if (side.size() > 1) {
            side.removeLast();
        }
        return side;
    }

    private static boolean turnsLeft(double[] a, double[] b, double[] c) {
        return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]) > 0;
    }

    /**
     * Corners of a polygon around a sphere or the light: x and y of each in turn, in pixels of the picture. Empty if
     * part of the outline is behind the camera, or the camera is in the sphere.
     *
     * <p>The rays that touch the sphere, with center C at distance d from the camera and radius r, do so on a circle
     * about {@code C - C / |C| * r^2 / d} of radius {@code r * sqrt(1 - r^2 / d^2)}, in a plane across the line to the
     * center.
     */
    public static double[] ofSphere(FrameInput input, int body, int count) {
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
