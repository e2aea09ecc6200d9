package dev.twister.gui.model;

import dev.twister.gui.model.NumberSetting.Scale;
import dev.twister.scene.Range;
import dev.twister.scene.Scene;
import dev.twister.scene.SceneLimits;
import dev.twister.scene.Vector3;
import java.util.function.BiFunction;
import java.util.function.ToDoubleFunction;

/** The numbers of a sphere or a mesh, by its {@link BodyNumber}. */
public final class BodyNumbers {
    private final String kind;
    private final String middle;
    private final int body;

    private BodyNumbers(String kind, String middle, int body) {
        this.kind = kind;
        this.middle = middle;
        this.body = body;
    }

    /** The numbers of a sphere. */
    public static BodyNumbers ofSphere(int body) {
        return new BodyNumbers("Sphere", "the sphere's center", body);
    }

    /** The numbers of a mesh. */
    public static BodyNumbers ofMesh(int body) {
        return new BodyNumbers("Mesh", "the origin of the mesh's file", body);
    }

    public NumberSetting x() {
        return place("x", "from left to right", Vector3::x, (place, x) -> new Vector3(x, place.y(), place.z()));
    }

    public NumberSetting y() {
        return place("y", "in height", Vector3::y, (place, y) -> new Vector3(place.x(), y, place.z()));
    }

    public NumberSetting z() {
        return place("z", "from near to far", Vector3::z, (place, z) -> new Vector3(place.x(), place.y(), z));
    }

    /** A sphere's. */
    public NumberSetting radius() {
        return new NumberSetting(
                "Sphere radius",
                "The sphere's radius.",
                SceneLimits.LENGTH,
                new Range(0.05, 10),
                Scale.LOGARITHMIC,
                2,
                "m",
                scene -> BodyEdits.sphere(scene, body).radius(),
                (scene, radius) -> BodyEdits.editedSphere(scene, body, sphere -> sphere.withRadius(radius)));
    }

    /** A mesh's. */
    public NumberSetting scale() {
        return new NumberSetting(
                "Mesh scale",
                "Meters per unit of the mesh's file.",
                SceneLimits.SCALE,
                new Range(0.001, 1000),
                Scale.LOGARITHMIC,
                3,
                "",
                scene -> BodyEdits.mesh(scene, body).scale(),
                (scene, scale) -> BodyEdits.editedMesh(scene, body, mesh -> mesh.withScale(scale)));
    }

    /** A mesh's. */
    public NumberSetting yaw() {
        return turn(
                "yaw",
                "about the vertical axis, to the right",
                Vector3::y,
                (rotation, yaw) -> new Vector3(rotation.x(), yaw, rotation.z()));
    }

    /** A mesh's. */
    public NumberSetting pitch() {
        return turn(
                "pitch", "forwards", Vector3::x, (rotation, pitch) -> new Vector3(pitch, rotation.y(), rotation.z()));
    }

    /** A mesh's. */
    public NumberSetting roll() {
        return turn(
                "roll",
                "to its left side",
                Vector3::z,
                (rotation, roll) -> new Vector3(rotation.x(), rotation.y(), roll));
    }

    private NumberSetting place(
            String axis,
            String direction,
            ToDoubleFunction<Vector3> reader,
            BiFunction<Vector3, Double, Vector3> writer) {
        return SceneNumbers.place(
                kind + " " + axis,
                "The place of " + middle + " " + direction + ".",
                scene -> reader.applyAsDouble(BodyEdits.position(scene, body)),
                (scene, number) -> BodyEdits.moved(scene, body, writer.apply(BodyEdits.position(scene, body), number)));
    }

    private NumberSetting turn(
            String name,
            String direction,
            ToDoubleFunction<Vector3> reader,
            BiFunction<Vector3, Double, Vector3> writer) {
        return new NumberSetting(
                "Mesh " + name,
                "How far the mesh is turned " + direction + ". It is rolled, then pitched, then turned.",
                SceneLimits.ROTATION,
                new Range(-180, 180),
                Scale.LINEAR,
                1,
                "°",
                scene -> reader.applyAsDouble(rotation(scene)),
                (scene, degrees) -> BodyEdits.editedMesh(
                        scene, body, mesh -> mesh.withRotation(writer.apply(mesh.rotation(), degrees))));
    }

    private Vector3 rotation(Scene scene) {
        return BodyEdits.mesh(scene, body).rotation();
    }
}
