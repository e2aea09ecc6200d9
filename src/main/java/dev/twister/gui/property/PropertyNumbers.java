package dev.twister.gui.property;

import dev.twister.gui.edit.BodyEdits;
import dev.twister.scene.Camera;
import dev.twister.scene.Light;
import dev.twister.scene.Mesh;
import dev.twister.scene.Scene;
import dev.twister.scene.Sphere;
import dev.twister.scene.property.BodyProperties;
import dev.twister.scene.property.CameraProperties;
import dev.twister.scene.property.LightProperties;
import dev.twister.scene.property.Property;
import dev.twister.scene.property.PropertyType;
import dev.twister.scene.property.Row;
import dev.twister.scene.property.SceneProperties;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.IntSupplier;
import java.util.stream.IntStream;
import java.util.stream.Stream;

/** The numbers that the panel shows of the table of properties: one row each, three of a vector. */
public final class PropertyNumbers {
    public static final NumberProperty<Scene> EXPOSURE = of(SceneProperties.EXPOSURE.within(
                    Scene::rendering, Scene::withRendering))
            .getFirst();
    public static final NumberProperty<Camera> FOCUS_DISTANCE =
            of(CameraProperties.FOCUS_DISTANCE).getFirst();

    private static final List<String> AXES = List.of(" x", " y", " z");
    private static final List<String> ANGLES = List.of(" yaw", " pitch", " roll");

    private PropertyNumbers() {}

    /** The rows of a property; none where it is not made of numbers, or is a color. */
    public static <T> List<NumberProperty<T>> of(Property<T, ?> property) {
        Row row = property.row();
        if (property.count() == 0 || row.label().isEmpty() || property.type() instanceof PropertyType.Color) {
            return List.of();
        }
        NumberScale scale = new NumberScale(property.range(), row.slide());
        String[] keys = row.keys().split(" ", -1);
        return IntStream.range(0, property.count())
                .mapToObj(index -> new NumberProperty<T>(
                        row.label() + ending(property, index),
                        row.hint(),
                        index < keys.length ? keys[index] : "",
                        scale,
                        part -> read(property, part, index),
                        (part, number) -> written(property, part, index, number)))
                .toList();
    }

    private static <T> double read(Property<T, ?> property, T part, int index) {
        return Optional.empty().equals(property.getter().apply(part))
                ? property.range().max()
                : property.numbers(part).get(index);
    }

    /** A number that may be missing is so at the upper end of its range. */
    private static <T> T written(Property<T, ?> property, T part, int index, double number) {
        if (property.type() instanceof PropertyType.Given<?>
                && number >= property.range().max()) {
            return property.without(part);
        }
        List<Double> numbers = new ArrayList<>(property.numbers(part));
        numbers.set(index, number);
        return property.withNumbers(part, numbers);
    }

    public static <T> List<NumberProperty<T>> of(List<Property<T, ?>> properties) {
        return properties.stream().flatMap(property -> of(property).stream()).toList();
    }

    private static String ending(Property<?, ?> property, int index) {
        return property.count() == 1 ? "" : (property.type() instanceof PropertyType.Turn ? ANGLES : AXES).get(index);
    }

    /** The field of view as a focal length. */
    public static NumberProperty<Scene> focalLength() {
        return DerivedNumbers.FOCAL_LENGTH.in(
                Scene::camera, (scene, edit) -> scene.withCamera(edit.apply(scene.camera())));
    }

    /**
     * The numbers of a property of a light.
     *
     * @param index place of the shown light in the scene's list
     */
    public static Stream<NumberProperty<Scene>> ofLight(Property<Light, ?> property, IntSupplier index) {
        if (property.equals(LightProperties.STRENGTH)) {
            return Stream.of(DerivedNumbers.strength(index));
        }
        List<NumberProperty<Light>> numbers =
                property.equals(LightProperties.COLOR) ? List.of(DerivedNumbers.BRIGHTNESS) : of(property);
        return numbers.stream()
                .map(number -> number.in(
                        scene -> DerivedNumbers.light(scene, index),
                        (scene, edit) -> DerivedNumbers.edited(scene, index, edit)));
    }

    /** The numbers of a body but for its material's; none unless it is a sphere or a mesh. */
    public static List<NumberProperty<Scene>> ofBody(Scene scene, int body) {
        return BodyEdits.isSphere(scene, body)
                ? of(BodyProperties.SPHERE).stream()
                        .map(number -> ofSphere(body, number))
                        .toList()
                : BodyEdits.isMesh(scene, body) ? ofMesh(BodyEdits.mesh(scene, body), body) : List.of();
    }

    private static List<NumberProperty<Scene>> ofMesh(Mesh mesh, int body) {
        Stream<NumberProperty<Mesh>> smooth =
                mesh.file().isPresent() ? of(BodyProperties.SMOOTH).stream() : Stream.empty();
        Stream<NumberProperty<Mesh>> animation = mesh.animation().isNone()
                ? Stream.empty()
                : of(BodyProperties.ANIMATION).stream()
                        .map(number -> number.in(
                                Mesh::animation, (whole, edit) -> whole.withAnimation(edit.apply(whole.animation()))));
        return Stream.of(of(BodyProperties.MESH).stream(), smooth, animation, DerivedNumbers.sides(mesh))
                .flatMap(numbers -> numbers)
                .map(number -> number.<Scene>in(
                        scene -> BodyEdits.mesh(scene, body), (scene, edit) -> BodyEdits.editedMesh(scene, body, edit)))
                .toList();
    }

    private static NumberProperty<Scene> ofSphere(int body, NumberProperty<Sphere> number) {
        return number.in(
                scene -> BodyEdits.sphere(scene, body), (scene, edit) -> BodyEdits.editedSphere(scene, body, edit));
    }
}
