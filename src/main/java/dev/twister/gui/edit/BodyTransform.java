package dev.twister.gui.edit;

import dev.twister.mesh.Affine;
import dev.twister.mesh.MeshPlacement;
import dev.twister.scene.Light;
import dev.twister.scene.Mesh;
import dev.twister.scene.Rotation;
import dev.twister.scene.Scene;
import dev.twister.scene.Vector3;
import dev.twister.scene.property.SceneLimits;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;

/**
 * Moves, rotates or scales bodies together, from where they were at the start.
 *
 * @param start the scene with the bodies at their displayed places
 * @param bodies movable ones
 * @param pivot what stays in its place when they are rotated or scaled
 */
public record BodyTransform(Scene start, Set<Integer> bodies, Vector3 pivot) {
    private static final double SNAP_METERS = 0.5;
    private static final double SNAP_DEGREES = 15;
    private static final double SNAP_FACTOR = 0.1;
    private static final double LEAST_FACTOR = 0.01;

    /** How bodies are changed. */
    public enum Mode {
        MOVE("Move", "m"),
        ROTATE("Rotate", "°"),
        SCALE("Scale", "times");

        private final String label;
        private final String unit;

        Mode(String label, String unit) {
            this.label = label;
            this.unit = unit;
        }

        public String label() {
            return label;
        }

        public String unit() {
            return unit;
        }
    }

    /** Takes those of a selection that are not locked, about the middle of their positions; empty if there are none. */
    public static Optional<BodyTransform> of(Scene scene, SelectedBodies selected) {
        Set<Integer> movable = selected.bodies().stream()
                .filter(body -> BodyEdits.isFree(scene, body))
                .collect(Collectors.toUnmodifiableSet());
        if (movable.isEmpty()) {
            return Optional.empty();
        }
        Vector3 sum =
                movable.stream().map(body -> BodyEdits.position(scene, body)).reduce(Vector3.ZERO, Vector3::plus);
        return Optional.of(new BodyTransform(scene, movable, sum.times(1.0 / movable.size())));
    }

    /** The same about another pivot. */
    public BodyTransform about(Vector3 other) {
        return new BodyTransform(start, bodies, other);
    }

    /** The number nearest to one that a snapped drag gives. */
    public static double snapped(Mode mode, double number) {
        double step = switch (mode) {
            case MOVE -> SNAP_METERS;
            case ROTATE -> SNAP_DEGREES;
            case SCALE -> SNAP_FACTOR;
        };
        return step * Math.rint(number / step);
    }

    /** The scene with the bodies moved. */
    public Scene moved(Scene scene, Vector3 by) {
        return changed(scene, place -> place.plus(by), mesh -> mesh, 1);
    }

    /**
     * The scene with the bodies turned about an axis through the pivot, as a mesh's yaw, pitch and roll turn it. Lights
     * then shine in another direction.
     */
    public Scene rotated(Scene scene, Vector3 axis, double degrees) {
        Scene rotated = changed(
                scene,
                place -> pivot.plus(turned(place.minus(pivot), axis, degrees)),
                mesh -> mesh.withRotation(turned(mesh.rotation(), axis, degrees)),
                1);
        for (int body : bodies) {
            if (BodyEdits.isLight(start, body)) {
                Vector3 direction = BodyEdits.light(start, body).shape().direction();
                rotated = BodyEdits.aimed(
                        rotated, body, turned(direction, axis, degrees).map(BodyTransform::rounded));
            }
        }
        return rotated;
    }

    /** The scene with a light among the bodies that shines at a place. */
    public Scene aimed(Scene scene, int body, Vector3 target) {
        Vector3 way = target.minus(BodyEdits.position(start, body));
        return way.length() == 0
                ? scene
                : BodyEdits.aimed(scene, body, way.normalized().map(BodyTransform::rounded));
    }

    /** The scene with the bodies larger, and farther from the pivot, by a factor. */
    public Scene scaled(Scene scene, double factor) {
        double size = Math.max(LEAST_FACTOR, Math.abs(factor));
        return changed(
                scene,
                place -> pivot.plus(place.minus(pivot).times(size)),
                mesh -> mesh.withScale(SceneLimits.FACTOR.clamp(mesh.scale() * size)),
                size);
    }

    private interface Placing {
        Vector3 of(Vector3 place);
    }

    private interface Turning {
        Mesh of(Mesh mesh);
    }

    private Scene changed(Scene scene, Placing placing, Turning turning, double size) {
        Scene changed = BodyEdits.edited(
                scene,
                bodies,
                (body, sphere) -> sphere.withPosition(place(body, placing))
                        .withRadius(SceneLimits.LENGTH.clamp(
                                BodyEdits.sphere(start, body).radius() * size)),
                (body, mesh) ->
                        turned(mesh, turning.of(BodyEdits.mesh(start, body))).withPosition(place(body, placing)));
        for (int body : bodies) {
            if (BodyEdits.isLight(start, body)) {
                Light light = BodyEdits.light(start, body);
                changed = BodyEdits.withLight(
                        changed,
                        body,
                        BodyEdits.light(changed, body)
                                .withPosition(place(body, placing))
                                .withRadius(SceneLimits.LENGTH.clamp(light.radius() * size)));
            }
        }
        return changed;
    }

    private static Mesh turned(Mesh mesh, Mesh like) {
        return mesh.withRotation(like.rotation()).withScale(like.scale());
    }

    private Vector3 place(int body, Placing placing) {
        return SceneLimits.POSITION.clamp(placing.of(BodyEdits.position(start, body)));
    }

    /** Rodrigues' formula. */
    private static Vector3 turned(Vector3 vector, Vector3 axis, double degrees) {
        double cosine = Math.cos(Math.toRadians(degrees));
        double sine = Math.sin(Math.toRadians(degrees));
        return vector.times(cosine)
                .plus(axis.cross(vector).times(sine))
                .plus(axis.times(axis.dot(vector) * (1 - cosine)));
    }

    /** The rotation of a mesh that is turned further. */
    private static Rotation turned(Rotation rotation, Vector3 axis, double degrees) {
        List<Vector3> columns = List.of(Axis.X, Axis.Y, Axis.Z).stream()
                .map(along -> along.from(Vector3.ZERO, 1))
                .map(column -> turned(column, new Vector3(0, 0, 1), rotation.rollDegrees()))
                .map(column -> turned(column, new Vector3(1, 0, 0), rotation.pitchDegrees()))
                .map(column -> turned(column, new Vector3(0, 1, 0), rotation.yawDegrees()))
                .map(column -> turned(column, axis, degrees))
                .toList();
        Rotation exact = MeshPlacement.angles(new Affine(columns.get(0), columns.get(1), columns.get(2), Vector3.ZERO));
        return new Rotation(rounded(exact.yawDegrees()), rounded(exact.pitchDegrees()), rounded(exact.rollDegrees()));
    }

    /** Without the last digits, which are errors, and without the negative zero. */
    private static double rounded(double number) {
        return Math.rint(number * 1e6) / 1e6 + 0.0;
    }
}
