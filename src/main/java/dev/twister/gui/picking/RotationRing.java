package dev.twister.gui.picking;

import dev.twister.gui.edit.Axis;
import dev.twister.gui.edit.BodyTransform;
import dev.twister.gui.picking.AxisHandle.Point;
import dev.twister.scene.Vector3;
import dev.twister.world.FrameInput;
import java.util.ArrayList;
import java.util.List;
import java.util.OptionalDouble;
import java.util.stream.IntStream;

/**
 * The part of a circle about an axis by which bodies are rotated: the half nearer to the camera, or all of it where it
 * faces the camera.
 *
 * @param points along it, in pixels of the picture
 */
public record RotationRing(Axis axis, List<Point> points) {
    private static final int STEPS = 48;

    /** Of the view direction, along the axis: a circle seen edge on is not shown. */
    private static final double LEAST_FACING = 0.12;

    /** The same, from which on all of the circle is shown. */
    private static final double FACING = 0.97;

    /**
     * The rings of a body that can be grabbed.
     *
     * @param middle of the body
     * @param radius of a ring that faces the camera, in pixels of the picture
     */
    public static List<RotationRing> of(Projection projection, Vector3 middle, double radius) {
        List<RotationRing> rings = new ArrayList<>();
        if (projection.point(middle).length > 0) {
            double meters = radius / projection.pixelsPerMeter(middle);
            Vector3 toCamera = projection.viewpoint().minus(middle).normalized();
            for (Axis axis : Axis.values()) {
                double facing = Math.abs(axis.of(toCamera));
                List<Point> points = points(projection, middle, meters, axis, toCamera);
                if (facing >= LEAST_FACING && points.size() > 1) {
                    rings.add(new RotationRing(axis, points));
                }
            }
        }
        return rings;
    }

    private static List<Point> points(
            Projection projection, Vector3 middle, double meters, Axis axis, Vector3 toCamera) {
        Vector3 normal = axis.from(Vector3.ZERO, 1);
        boolean whole = Math.abs(axis.of(toCamera)) >= FACING;
        // Any direction in the plane where the circle faces the camera.
        Vector3 within = whole ? axis.next().from(Vector3.ZERO, 1) : axis.with(toCamera, 0);
        Vector3 near = within.normalized();
        Vector3 side = normal.cross(near);
        double span = whole ? Math.PI : Math.PI / 2;
        return IntStream.rangeClosed(-STEPS / 2, STEPS / 2)
                .mapToDouble(step -> step * span / (STEPS / 2))
                .mapToObj(angle ->
                        middle.plus(near.times(meters * Math.cos(angle))).plus(side.times(meters * Math.sin(angle))))
                .map(projection::point)
                .filter(pixel -> pixel.length > 0)
                .map(pixel -> new Point(pixel[0], pixel[1]))
                .toList();
    }

    /** From a place to the nearest one of the ring, in pixels. */
    public double distance(double x, double y) {
        return IntStream.range(1, points.size())
                .mapToDouble(i -> new Point(x, y).distance(points.get(i - 1), points.get(i)))
                .min()
                .orElse(Double.POSITIVE_INFINITY);
    }

    /**
     * How far the pointer is around an axis, as {@link BodyTransform#rotated} counts.
     *
     * @param pivot a point of the axis
     * @return degrees; empty where the pointer's ray does not meet the plane across the axis
     */
    public static OptionalDouble degrees(FrameInput input, Axis axis, Vector3 pivot, double x, double y) {
        PointerRay ray = PointerRay.through(input, x, y);
        Vector3 direction = ray.direction();
        double meters = axis.of(pivot.minus(ray.along(0))) / axis.of(direction);
        if (!(meters > 0 && Double.isFinite(meters))) {
            return OptionalDouble.empty();
        }
        Vector3 spot = ray.along(meters).minus(pivot);
        return OptionalDouble.of(Math.toDegrees(
                Math.atan2(axis.next().next().of(spot), axis.next().of(spot))));
    }
}
