package dev.twister.gui.model;

import dev.twister.scene.Mesh;
import dev.twister.scene.Scene;
import dev.twister.scene.Vector3;
import dev.twister.world.SceneMeshes;
import java.util.List;
import java.util.function.ToDoubleFunction;

/**
 * The room that a body takes.
 *
 * @param middle of the body, in meters
 * @param radius of a sphere around it, in meters
 * @param halfWidth from the middle to its right end, in meters
 */
public record BodyExtent(Vector3 middle, double radius, double halfWidth) {
    /** Where a mesh has not been read yet. */
    private static final double UNKNOWN = 1;

    /** A copy beside it does not touch it. */
    private static final double APART = 2.2;

    /** That of a movable body. */
    public static BodyExtent of(Scene scene, SceneMeshes meshes, int body) {
        if (!BodyEdits.isMesh(scene, body)) {
            double radius = body == BodyNumber.LIGHT
                    ? scene.light().radius()
                    : BodyEdits.sphere(scene, body).radius();
            return new BodyExtent(BodyEdits.position(scene, body), radius, radius);
        }
        Mesh mesh = BodyEdits.mesh(scene, body);
        return meshes.holds(mesh) ? around(meshes.farPoints(mesh)) : new BodyExtent(mesh.position(), UNKNOWN, UNKNOWN);
    }

    /** Meters to the right, for another one like it that does not touch it. */
    public double apart() {
        return APART * halfWidth;
    }

    /** The same, so far away. */
    public BodyExtent movedBy(double x, double y, double z) {
        return new BodyExtent(new Vector3(middle.x() + x, middle.y() + y, middle.z() + z), radius, halfWidth);
    }

    private static BodyExtent around(List<Vector3> points) {
        double[] x = ends(points, Vector3::x);
        double[] y = ends(points, Vector3::y);
        double[] z = ends(points, Vector3::z);
        Vector3 middle = new Vector3((x[0] + x[1]) / 2, (y[0] + y[1]) / 2, (z[0] + z[1]) / 2);
        double radius = points.stream()
                .mapToDouble(point ->
                        Math.hypot(Math.hypot(point.x() - middle.x(), point.y() - middle.y()), point.z() - middle.z()))
                .max()
                .orElseThrow();
        return new BodyExtent(middle, radius, (x[1] - x[0]) / 2);
    }

    private static double[] ends(List<Vector3> points, ToDoubleFunction<Vector3> axis) {
        return new double[] {
            points.stream().mapToDouble(axis).min().orElseThrow(),
            points.stream().mapToDouble(axis).max().orElseThrow()
        };
    }
}
