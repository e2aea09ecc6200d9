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

    /** The distance at which a copy does not touch the body. */
    private static final double APART = 2.2;

    /** That of a movable body. */
    public static BodyExtent of(Scene scene, SceneMeshes meshes, int body) {
        if (!BodyEdits.isMesh(scene, body)) {
            double radius = BodyEdits.isLight(scene, body)
                    ? BodyEdits.light(scene, body).radius()
                    : BodyEdits.sphere(scene, body).radius();
            return new BodyExtent(BodyEdits.position(scene, body), radius, radius);
        }
        Mesh mesh = BodyEdits.mesh(scene, body);
        return meshes.holds(mesh) ? around(meshes.farPoints(mesh)) : new BodyExtent(mesh.position(), UNKNOWN, UNKNOWN);
    }

    /** That of bodies together; at least one. */
    public static BodyExtent of(List<BodyExtent> bodies) {
        double[] x = ends(bodies, body -> body.middle().x(), BodyExtent::halfWidth);
        double[] y = ends(bodies, body -> body.middle().y(), BodyExtent::radius);
        double[] z = ends(bodies, body -> body.middle().z(), BodyExtent::radius);
        Vector3 middle = new Vector3((x[0] + x[1]) / 2, (y[0] + y[1]) / 2, (z[0] + z[1]) / 2);
        double radius = bodies.stream()
                .mapToDouble(body -> body.middle().minus(middle).length() + body.radius())
                .max()
                .orElseThrow();
        return new BodyExtent(middle, radius, (x[1] - x[0]) / 2);
    }

    /** Meters to the right, for another one like it that does not touch it. */
    public double apart() {
        return APART * halfWidth;
    }

    /** The same, so far away. */
    public BodyExtent movedBy(Vector3 way) {
        return new BodyExtent(middle.plus(way), radius, halfWidth);
    }

    private static BodyExtent around(List<Vector3> points) {
        double[] x = ends(points, Vector3::x, _ -> 0);
        double[] y = ends(points, Vector3::y, _ -> 0);
        double[] z = ends(points, Vector3::z, _ -> 0);
        Vector3 middle = new Vector3((x[0] + x[1]) / 2, (y[0] + y[1]) / 2, (z[0] + z[1]) / 2);
        double radius = points.stream()
                .mapToDouble(point -> point.minus(middle).length())
                .max()
                .orElseThrow();
        return new BodyExtent(middle, radius, (x[1] - x[0]) / 2);
    }

    private static <T> double[] ends(List<T> things, ToDoubleFunction<T> place, ToDoubleFunction<T> half) {
        return new double[] {
            things.stream()
                    .mapToDouble(thing -> place.applyAsDouble(thing) - half.applyAsDouble(thing))
                    .min()
                    .orElseThrow(),
            things.stream()
                    .mapToDouble(thing -> place.applyAsDouble(thing) + half.applyAsDouble(thing))
                    .max()
                    .orElseThrow()
        };
    }
}
