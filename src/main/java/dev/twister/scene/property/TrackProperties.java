package dev.twister.scene.property;

import dev.twister.scene.Ground;
import dev.twister.scene.Material;
import dev.twister.scene.Mesh;
import dev.twister.scene.Scene;
import dev.twister.scene.Sphere;
import dev.twister.scene.TrackTarget;
import java.util.List;
import java.util.Optional;
import java.util.function.BiFunction;
import java.util.function.Function;
import java.util.stream.Stream;

/** The properties that tracks can change. */
public final class TrackProperties {
    public static final List<Property<Sphere, ?>> SPHERE =
            animated(BodyProperties.SPHERE, Sphere::material, Sphere::withMaterial);

    /** The animation's property is called as its place in a scene file. */
    public static final List<Property<Mesh, ?>> MESH = Stream.concat(
                    animated(BodyProperties.MESH, Mesh::own, Mesh::withMaterial).stream(),
                    Property.within(BodyProperties.ANIMATION, Mesh::animation, Mesh::withAnimation).stream()
                            .filter(Property::isAnimated)
                            .<Property<Mesh, ?>>map(property -> property.withName("animation." + property.name())))
            .toList();

    /** The plane cannot emit. */
    public static final List<Property<Ground, ?>> PLANE =
            animated(BodyProperties.PLANE, Ground::material, Ground::withMaterial).stream()
                    .filter(property -> !MaterialProperties.isOfEmission(property))
                    .toList();

    private TrackProperties() {}

    /** The properties of a part of a scene, each read from and written to the whole scene. */
    public static List<Property<Scene, ?>> of(TrackTarget target) {
        int index = target.index();
        return switch (target.kind()) {
            case CAMERA -> of(CameraProperties.ALL, Scene::camera, Scene::withCamera);
            case LIGHT ->
                of(
                        LightProperties.ALL,
                        scene -> scene.lights().get(index),
                        (scene, light) -> scene.withLights(scene.lights().with(index, light)));
            case PLANE -> of(PLANE, Scene::ground, Scene::withGround);
            case SPHERE ->
                of(
                        SPHERE,
                        scene -> scene.spheres().get(index),
                        (scene, sphere) -> scene.withBodies(scene.bodies().withSphere(index, sphere)));
            case MESH ->
                of(
                        MESH,
                        scene -> scene.meshes().get(index),
                        (scene, mesh) -> scene.withBodies(scene.bodies().withMesh(index, mesh)));
            case SKY -> of(SceneProperties.SKY, Scene::sky, Scene::withSky);
            case SHADING -> of(SceneProperties.SHADING, Scene::shading, Scene::withShading);
            case RENDERING -> of(SceneProperties.RENDERING, Scene::rendering, Scene::withRendering);
        };
    }

    /** The property of a target that has that name. */
    public static Optional<Property<Scene, ?>> find(TrackTarget target, String name) {
        return of(target).stream()
                .filter(property -> property.name().equals(name))
                .findFirst();
    }

    private static <T> List<Property<Scene, ?>> of(
            List<Property<T, ?>> properties, Function<Scene, T> part, BiFunction<Scene, T, Scene> withPart) {
        return Property.within(properties.stream().filter(Property::isAnimated).toList(), part, withPart);
    }

    private static <T> List<Property<T, ?>> animated(
            List<Property<T, ?>> own, Function<T, Material> material, BiFunction<T, Material, T> withMaterial) {
        return Stream.concat(own.stream(), Property.within(MaterialProperties.ALL, material, withMaterial).stream())
                .filter(Property::isAnimated)
                .toList();
    }
}
