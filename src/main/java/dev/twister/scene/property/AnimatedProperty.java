package dev.twister.scene.property;

import dev.twister.scene.Camera;
import dev.twister.scene.Ground;
import dev.twister.scene.Light;
import dev.twister.scene.Material;
import dev.twister.scene.Mesh;
import dev.twister.scene.Rendering;
import dev.twister.scene.Rgb;
import dev.twister.scene.Rotation;
import dev.twister.scene.Scene;
import dev.twister.scene.Shading;
import dev.twister.scene.Sky;
import dev.twister.scene.Sphere;
import dev.twister.scene.TrackTarget;
import dev.twister.scene.Vector3;
import java.util.List;
import java.util.Optional;
import java.util.function.BiFunction;
import java.util.function.Function;
import java.util.function.ToDoubleFunction;
import java.util.stream.Stream;

/**
 * A property that a track can change.
 *
 * @param name as in a scene file
 * @param size how many numbers it has: 1 or 3
 * @param range of each of them
 * @param getter the numbers, in the order of a scene file
 */
public record AnimatedProperty<T>(
        String name, int size, Range range, Function<T, List<Double>> getter, BiFunction<T, List<Double>, T> wither) {
    private static final List<AnimatedProperty<Material>> MATERIAL = List.of(
            color("color", SceneLimits.ALBEDO, Material::color, Material::withColor),
            number("reflectivity", SceneLimits.REFLECTIVITY, Material::reflectivity, Material::withReflectivity),
            number("roughness", SceneLimits.ROUGHNESS, Material::roughness, Material::withRoughness),
            number("metallic", SceneLimits.METALLIC, Material::metallic, Material::withMetallic),
            number("transmission", SceneLimits.TRANSMISSION, Material::transmission, Material::withTransmission),
            number("ior", SceneLimits.IOR, Material::ior, Material::withIor),
            color(
                    "emission",
                    SceneLimits.RADIANCE,
                    material -> material.emission().color(),
                    (material, color) ->
                            material.withEmission(material.emission().withColor(color))),
            number(
                    "emissionStrength",
                    SceneLimits.EMISSION_STRENGTH,
                    material -> material.emission().strength(),
                    (material, strength) ->
                            material.withEmission(material.emission().withStrength(strength))));

    public static final List<AnimatedProperty<Camera>> CAMERA = List.of(
            number(
                    "fieldOfView",
                    SceneLimits.FIELD_OF_VIEW,
                    Camera::fieldOfViewDegrees,
                    Camera::withFieldOfViewDegrees),
            number("aperture", SceneLimits.APERTURE, Camera::aperture, Camera::withAperture),
            number("focusDistance", SceneLimits.FOCUS_DISTANCE, Camera::focusDistance, Camera::withFocusDistance));

    public static final List<AnimatedProperty<Light>> LIGHT = List.of(
            vector("position", SceneLimits.POSITION, Light::position, Light::withPosition),
            number("radius", SceneLimits.LENGTH, Light::radius, Light::withRadius),
            color("color", SceneLimits.RADIANCE, Light::color, Light::withColor),
            number(
                    "strength",
                    SceneLimits.LIGHT_STRENGTH,
                    light -> light.strength().orElse(1.0),
                    (light, strength) -> light.withStrength(strength)),
            number("share", SceneLimits.LIGHT_SHARE, Light::share, Light::withShare));

    /** The plane cannot emit. */
    public static final List<AnimatedProperty<Ground>> PLANE = Stream.concat(
                    Stream.of(number("height", SceneLimits.POSITION, Ground::height, Ground::withHeight)),
                    MATERIAL.stream()
                            .filter(property -> !property.name().startsWith("emission"))
                            .map(property -> property.within(Ground::material, Ground::withMaterial)))
            .toList();

    public static final List<AnimatedProperty<Sphere>> SPHERE = Stream.concat(
                    Stream.of(
                            vector("position", SceneLimits.POSITION, Sphere::position, Sphere::withPosition),
                            number("radius", SceneLimits.LENGTH, Sphere::radius, Sphere::withRadius)),
                    MATERIAL.stream().map(property -> property.within(Sphere::material, Sphere::withMaterial)))
            .toList();

    public static final List<AnimatedProperty<Mesh>> MESH = Stream.concat(
                    Stream.of(
                            vector("position", SceneLimits.POSITION, Mesh::position, Mesh::withPosition),
                            new AnimatedProperty<Mesh>(
                                    "rotation",
                                    3,
                                    SceneLimits.ROTATION,
                                    mesh -> List.of(
                                            mesh.rotation().yawDegrees(),
                                            mesh.rotation().pitchDegrees(),
                                            mesh.rotation().rollDegrees()),
                                    (mesh, turn) ->
                                            mesh.withRotation(new Rotation(turn.get(0), turn.get(1), turn.get(2)))),
                            number("scale", SceneLimits.SCALE, Mesh::scale, Mesh::withScale)),
                    MATERIAL.stream().map(property -> property.within(Mesh::own, Mesh::withMaterial)))
            .toList();

    public static final List<AnimatedProperty<Sky>> SKY = List.of(
            number("rotation", SceneLimits.SKY_ROTATION, Sky::rotationDegrees, Sky::withRotationDegrees),
            number("strength", SceneLimits.SKY_STRENGTH, Sky::strength, Sky::withStrength));

    public static final List<AnimatedProperty<Shading>> SHADING =
            List.of(number("ambient", SceneLimits.AMBIENT, Shading::ambient, (_, ambient) -> new Shading(ambient)));

    public static final List<AnimatedProperty<Rendering>> RENDERING =
            List.of(number("exposure", SceneLimits.EXPOSURE, Rendering::exposure, Rendering::withExposure));

    /** The properties of a part of a scene, each read from and written to the whole scene. */
    public static List<AnimatedProperty<Scene>> of(TrackTarget target) {
        int index = target.index();
        return switch (target.kind()) {
            case CAMERA -> within(CAMERA, Scene::camera, Scene::withCamera);
            case LIGHT ->
                within(
                        LIGHT,
                        scene -> scene.lights().get(index),
                        (scene, light) -> scene.withLights(scene.lights().with(index, light)));
            case PLANE -> within(PLANE, Scene::ground, Scene::withGround);
            case SPHERE ->
                within(
                        SPHERE,
                        scene -> scene.spheres().get(index),
                        (scene, sphere) -> scene.withBodies(scene.bodies().withSphere(index, sphere)));
            case MESH ->
                within(
                        MESH,
                        scene -> scene.meshes().get(index),
                        (scene, mesh) -> scene.withBodies(scene.bodies().withMesh(index, mesh)));
            case SKY -> within(SKY, Scene::sky, Scene::withSky);
            case SHADING -> within(SHADING, Scene::shading, Scene::withShading);
            case RENDERING -> within(RENDERING, Scene::rendering, Scene::withRendering);
        };
    }

    /** The property of a target that has that name. */
    public static Optional<AnimatedProperty<Scene>> find(TrackTarget target, String name) {
        return of(target).stream()
                .filter(property -> property.name().equals(name))
                .findFirst();
    }

    public List<Double> read(T from) {
        return getter.apply(from);
    }

    /** A copy with other numbers, each brought into its range. */
    public T write(T to, List<Double> numbers) {
        return wither.apply(to, numbers.stream().map(range::clamp).toList());
    }

    /** The same property of something that has this part. */
    private <W> AnimatedProperty<W> within(Function<W, T> part, BiFunction<W, T, W> withPart) {
        return new AnimatedProperty<>(
                name,
                size,
                range,
                part.andThen(getter),
                (whole, numbers) -> withPart.apply(whole, wither.apply(part.apply(whole), numbers)));
    }

    private static <W, T> List<AnimatedProperty<W>> within(
            List<AnimatedProperty<T>> properties, Function<W, T> part, BiFunction<W, T, W> withPart) {
        return properties.stream()
                .map(property -> property.within(part, withPart))
                .toList();
    }

    private static <T> AnimatedProperty<T> number(
            String name, Range range, ToDoubleFunction<T> getter, BiFunction<T, Double, T> wither) {
        return new AnimatedProperty<>(
                name,
                1,
                range,
                from -> List.of(getter.applyAsDouble(from)),
                (to, numbers) -> wither.apply(to, numbers.getFirst()));
    }

    private static <T> AnimatedProperty<T> vector(
            String name, Range range, Function<T, Vector3> getter, BiFunction<T, Vector3, T> wither) {
        return new AnimatedProperty<>(
                name,
                3,
                range,
                from -> {
                    Vector3 vector = getter.apply(from);
                    return List.of(vector.x(), vector.y(), vector.z());
                },
                (to, axes) -> wither.apply(to, new Vector3(axes.get(0), axes.get(1), axes.get(2))));
    }

    private static <T> AnimatedProperty<T> color(
            String name, Range range, Function<T, Rgb> getter, BiFunction<T, Rgb, T> wither) {
        return new AnimatedProperty<>(
                name,
                3,
                range,
                from -> {
                    Rgb color = getter.apply(from);
                    return List.of(color.red(), color.green(), color.blue());
                },
                (to, channels) -> wither.apply(to, new Rgb(channels.get(0), channels.get(1), channels.get(2))));
    }
}
