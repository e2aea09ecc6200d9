package dev.twister.gui.edit;

import dev.twister.scene.Mesh;
import dev.twister.scene.Scene;
import dev.twister.scene.Shape;
import dev.twister.scene.Vector3;
import dev.twister.world.SceneMeshes;
import java.util.DoubleSummaryStatistics;
import java.util.List;
import java.util.stream.Stream;

/**
 * The room that a body takes: what a sphere and a box around it have in common.
 *
 * @param middle of the body, in meters
 * @param radius of the sphere, in meters
 * @param half of each of the box's sides, in meters
 */
public record BodyExtent(Vector3 middle, double radius, Vector3 half) {
    /** Where a mesh has not been read yet. */
    private static final double UNKNOWN = 1;

    /** The distance at which a copy does not touch the body. */
    private static final double APART = 2.2;

    /** That of a movable body. */
    public static BodyExtent of(Scene scene, SceneMeshes meshes, int body) {
        if (!BodyEdits.isMesh(scene, body)) {
            double radius = BodyEdits.isLight(scene, body)
                    ? BodyEdits.light(scene, body).radius()
                    : BodyEdits.sphere(scene, body).radius();
            return ball(BodyEdits.position(scene, body), radius);
        }
        Mesh mesh = BodyEdits.mesh(scene, body);
        return meshes.holds(mesh) ? around(meshes.farPoints(mesh)) : unread(mesh);
    }

    /** That of a sphere. */
    public static BodyExtent ball(Vector3 middle, double radius) {
        return new BodyExtent(middle, radius, new Vector3(radius, radius, radius));
    }

    /** That of a box along the axes. */
    public static BodyExtent box(Vector3 middle, Vector3 half) {
        return new BodyExtent(middle, half.length(), half);
    }

    /** That of bodies together; at least one. */
    public static BodyExtent of(List<BodyExtent> bodies) {
        BodyExtent box = boxAround(bodies.stream()
                .flatMap(body -> Stream.of(
                        body.middle().minus(body.half()), body.middle().plus(body.half())))
                .toList());
        double radius = bodies.stream()
                .mapToDouble(body -> body.middle().minus(box.middle()).length() + body.radius())
                .max()
                .orElseThrow();
        return new BodyExtent(box.middle(), radius, box.half());
    }

    /** Meters to the right, for another one like it that does not touch it. */
    public double apart() {
        return APART * half.x();
    }

    /** The same, so far away. */
    public BodyExtent movedBy(Vector3 way) {
        return new BodyExtent(middle.plus(way), radius, half);
    }

    /**
     * Whether another body may touch this one.
     *
     * @param gap that is left between them at least, in meters
     */
    public boolean isNear(BodyExtent other, double gap) {
        Vector3 way = other.middle().minus(middle);
        return way.length() < radius + other.radius() + gap
                && Math.abs(way.x()) < half.x() + other.half().x() + gap
                && Math.abs(way.y()) < half.y() + other.half().y() + gap
                && Math.abs(way.z()) < half.z() + other.half().z() + gap;
    }

    private static BodyExtent unread(Mesh mesh) {
        return mesh.geometry() instanceof Shape shape
                ? ball(mesh.position(), shape.size().length() / 2 * mesh.scale())
                : ball(mesh.position(), UNKNOWN);
    }

    private static BodyExtent around(List<Vector3> points) {
        BodyExtent box = boxAround(points);
        double radius = points.stream()
                .mapToDouble(point -> point.minus(box.middle()).length())
                .max()
                .orElseThrow();
        return new BodyExtent(box.middle(), radius, box.half());
    }

    private static BodyExtent boxAround(List<Vector3> points) {
        DoubleSummaryStatistics x = points.stream().mapToDouble(Vector3::x).summaryStatistics();
        DoubleSummaryStatistics y = points.stream().mapToDouble(Vector3::y).summaryStatistics();
        DoubleSummaryStatistics z = points.stream().mapToDouble(Vector3::z).summaryStatistics();
        Vector3 least = new Vector3(x.getMin(), y.getMin(), z.getMin());
        Vector3 most = new Vector3(x.getMax(), y.getMax(), z.getMax());
        return box(least.plus(most).times(0.5), most.minus(least).times(0.5));
    }
}
