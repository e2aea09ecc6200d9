package dev.twister.gui.picking;

import dev.twister.gui.edit.BodyEdits;
import dev.twister.gui.edit.BodyExtent;
import dev.twister.kernel.Layout;
import dev.twister.scene.Mesh;
import dev.twister.scene.Scene;
import dev.twister.scene.Vector3;
import dev.twister.scene.property.SceneLimits;
import dev.twister.world.FrameInput;
import dev.twister.world.SceneMeshes;
import java.util.List;
import java.util.Optional;
import java.util.function.IntPredicate;

/**
 * A place on the surface of a body.
 *
 * @param normal of length 1, to the side from which it is seen
 */
public record SurfacePoint(Vector3 place, Vector3 normal) {
    /** Meters, beside which a scene is small. */
    private static final double FAR = 1e9;

    /**
     * What is seen at a place on the picture; empty for the sky.
     *
     * @param x in pixels of the picture from its left border
     * @param y in pixels from its upper border
     * @param passed whether a body of the picture is looked through
     */
    public static Optional<SurfacePoint> under(FrameInput input, double x, double y, IntPredicate passed) {
        PointerRay ray = PointerRay.through(input, x, y).beyond(input, passed);
        return ray.body() == Layout.NOTHING
                ? Optional.empty()
                : Optional.of(new SurfacePoint(ray.along(ray.distance()), ray.normal(input)));
    }

    /** What a light shines at that is aimed at a place on the picture: what is seen there, or the sky far away. */
    public static Vector3 aim(FrameInput input, double x, double y) {
        return under(input, x, y, input::isLight)
                .map(SurfacePoint::place)
                .orElseGet(() -> PointerRay.through(input, x, y).along(FAR));
    }

    /**
     * The shape of a body that is put on surfaces.
     *
     * @param radius of a sphere or a light, in meters
     * @param corners of a mesh, from its position; empty for others
     */
    public record RestingBody(double radius, List<Vector3> corners) {
        /** That of a movable body; a mesh that has not been read is a point. */
        public static RestingBody of(Scene scene, SceneMeshes meshes, int body) {
            if (!BodyEdits.isMesh(scene, body)) {
                return new RestingBody(BodyExtent.of(scene, meshes, body).radius(), List.of());
            }
            Mesh mesh = BodyEdits.mesh(scene, body);
            List<Vector3> points = meshes.holds(mesh) ? meshes.farPoints(mesh) : List.of();
            return new RestingBody(
                    0,
                    points.stream().map(point -> point.minus(mesh.position())).toList());
        }

        /** The position at which the body touches a surface there. */
        public Vector3 on(SurfacePoint surface) {
            double reach = corners.stream()
                    .mapToDouble(corner -> -corner.dot(surface.normal()))
                    .max()
                    .orElse(radius);
            return SceneLimits.POSITION.clamp(
                    surface.place().plus(surface.normal().times(reach)));
        }
    }
}
