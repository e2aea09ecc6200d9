package dev.twister.gui.property;

import dev.twister.gui.edit.Axis;
import dev.twister.gui.edit.BodyEdits;
import dev.twister.gui.property.NumberScale.Spread;
import dev.twister.scene.Geometry;
import dev.twister.scene.Mesh;
import dev.twister.scene.Rotation;
import dev.twister.scene.Scene;
import dev.twister.scene.Shape;
import dev.twister.scene.Sphere;
import dev.twister.scene.Triangles;
import dev.twister.scene.property.Range;
import dev.twister.scene.property.SceneLimits;
import java.util.List;
import java.util.function.BiFunction;
import java.util.function.ToDoubleFunction;
import java.util.function.UnaryOperator;
import java.util.stream.Stream;

/** The numbers of spheres and meshes, except those of their materials. */
public final class BodyNumbers {
    private static final NumberScale RADIUS =
            new NumberScale(SceneLimits.LENGTH, new Range(0.05, 10), Spread.LOGARITHMIC, 2, "m");
    private static final NumberScale FILE_UNIT =
            new NumberScale(SceneLimits.SCALE, new Range(0.001, 1000), Spread.LOGARITHMIC, 3, "");
    private static final NumberScale ANGLE =
            new NumberScale(SceneLimits.ROTATION, new Range(-180, 180), Spread.LINEAR, 1, "°");

    public static final List<NumberProperty<Sphere>> SPHERE = List.of(
            sphere(Axis.X, "from left to right", "Alt+4"),
            sphere(Axis.Y, "in height", "Alt+5"),
            sphere(Axis.Z, "from near to far", "Alt+6"),
            new NumberProperty<>(
                    "Sphere radius", "The sphere's radius.", "Alt+7", RADIUS, Sphere::radius, Sphere::withRadius));

    public static final List<NumberProperty<Mesh>> MESH = List.of(
            mesh(Axis.X, "from left to right", "Alt+4"),
            mesh(Axis.Y, "in height", "Alt+5"),
            mesh(Axis.Z, "from near to far", "Alt+6"),
            turn(
                    "yaw",
                    Rotation::yawDegrees,
                    Rotation::withYawDegrees,
                    "about the vertical axis, to the right",
                    "Alt+Shift+4"),
            turn("pitch", Rotation::pitchDegrees, Rotation::withPitchDegrees, "forwards", "Alt+Shift+5"),
            turn("roll", Rotation::rollDegrees, Rotation::withRollDegrees, "to its left side", "Alt+Shift+6"),
            new NumberProperty<>(
                    "Mesh scale",
                    "Meters per unit of the mesh's file; of a shape, the factor of its size.",
                    "Alt+7",
                    FILE_UNIT,
                    Mesh::scale,
                    Mesh::withScale));

    private static final NumberScale SIDE =
            new NumberScale(SceneLimits.LENGTH, new Range(0.05, 20), Spread.LOGARITHMIC, 2, "m");

    /** Of the width of a torus: its height must be below half of it. */
    private static final double MOST_OF_A_TORUS = 0.499;

    private static final List<NumberProperty<Shape>> SIDES = List.of(
            side("width", Axis.X, "Alt+Shift+8"),
            side("height", Axis.Y, "Alt+Shift+9"),
            side("depth", Axis.Z, "Alt+Shift+0"));

    private BodyNumbers() {}

    /** The numbers of a body; none unless it is a sphere or a mesh. */
    public static List<NumberProperty<Scene>> of(Scene scene, int body) {
        return BodyEdits.isSphere(scene, body)
                ? SPHERE.stream().map(number -> ofSphere(body, number)).toList()
                : BodyEdits.isMesh(scene, body) ? ofMesh(scene, body) : List.of();
    }

    private static List<NumberProperty<Scene>> ofMesh(Scene scene, int body) {
        Stream<NumberProperty<Mesh>> sides = switch (BodyEdits.mesh(scene, body).geometry()) {
            case Geometry.OfFile _, Triangles _ -> Stream.empty();
            case Shape shape ->
                SIDES.stream()
                        .limit(shape.kind() == Shape.Kind.QUAD ? 2 : 3)
                        .map(side -> side.in(BodyNumbers::shape, BodyNumbers::reshaped));
        };
        return Stream.concat(MESH.stream(), sides)
                .map(number -> ofMesh(body, number))
                .toList();
    }

    private static Shape shape(Mesh mesh) {
        if (mesh.geometry() instanceof Shape shape) {
            return shape;
        }
        throw new IllegalArgumentException("no shape: " + mesh.geometry().name());
    }

    private static Mesh reshaped(Mesh mesh, UnaryOperator<Shape> edit) {
        return mesh.withGeometry(edit.apply(shape(mesh)));
    }

    public static NumberProperty<Scene> ofSphere(int body, NumberProperty<Sphere> number) {
        return number.in(
                scene -> BodyEdits.sphere(scene, body), (scene, edit) -> BodyEdits.editedSphere(scene, body, edit));
    }

    private static NumberProperty<Scene> ofMesh(int body, NumberProperty<Mesh> number) {
        return number.in(
                scene -> BodyEdits.mesh(scene, body), (scene, edit) -> BodyEdits.editedMesh(scene, body, edit));
    }

    private static NumberProperty<Sphere> sphere(Axis axis, String direction, String key) {
        return new NumberProperty<>(
                "Sphere " + axis.label(),
                "The position of the sphere's center " + direction + ".",
                key,
                SceneNumbers.PLACE,
                sphere -> axis.of(sphere.position()),
                (sphere, number) -> sphere.withPosition(axis.with(sphere.position(), number)));
    }

    private static NumberProperty<Mesh> mesh(Axis axis, String direction, String key) {
        return new NumberProperty<>(
                "Mesh " + axis.label(),
                "The position of the origin of the mesh's file " + direction + ".",
                key,
                SceneNumbers.PLACE,
                mesh -> axis.of(mesh.position()),
                (mesh, number) -> mesh.withPosition(axis.with(mesh.position(), number)));
    }

    private static NumberProperty<Shape> side(String name, Axis axis, String key) {
        return new NumberProperty<>(
                "Shape " + name,
                "The " + name + " of the box that the shape fills before it is scaled and rotated.",
                key,
                SIDE,
                shape -> axis.of(shape.size()),
                (shape, meters) -> new Shape(shape.kind(), axis.with(shape.size(), possible(shape, axis, meters))));
    }

    /** The hole of a torus stays open. */
    private static double possible(Shape shape, Axis axis, double meters) {
        if (shape.kind() != Shape.Kind.TORUS || axis == Axis.Z) {
            return meters;
        }
        return axis == Axis.X
                ? Math.max(meters, shape.size().y() / MOST_OF_A_TORUS)
                : Math.min(meters, shape.size().x() * MOST_OF_A_TORUS);
    }

    private static NumberProperty<Mesh> turn(
            String name,
            ToDoubleFunction<Rotation> angle,
            BiFunction<Rotation, Double, Rotation> wither,
            String direction,
            String key) {
        return new NumberProperty<>(
                "Mesh " + name,
                "How far the mesh is turned " + direction + ". It is rolled, then pitched, then turned.",
                key,
                ANGLE,
                mesh -> angle.applyAsDouble(mesh.rotation()),
                (mesh, degrees) -> mesh.withRotation(wither.apply(mesh.rotation(), degrees)));
    }
}
