package dev.twister.scene.select;

import dev.twister.scene.Light;
import dev.twister.scene.Mesh;
import dev.twister.scene.Scene;
import dev.twister.scene.Sphere;
import dev.twister.scene.TrackTarget;
import dev.twister.scene.light.Lights;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;

/** The part of a scene that is not hidden. */
public final class VisibleBodies {
    private VisibleBodies() {}

    /**
     * The scene as it is rendered: without hidden bodies and their tracks, and without tags; itself where no body has
     * one.
     */
    public static Scene of(Scene scene) {
        return tags(scene).allMatch(Tag.NONE::equals) ? scene : untagged(scene);
    }

    /** The tags of all lights, spheres and meshes, in this order. */
    public static Stream<Tag> tags(Scene scene) {
        return Stream.of(
                        scene.lights().list().stream().map(Light::tag),
                        scene.spheres().stream().map(Sphere::tag),
                        scene.meshes().stream().map(Mesh::tag))
                .flatMap(tags -> tags);
    }

    private static Scene untagged(Scene scene) {
        List<Light> lights = scene.lights().list().stream()
                .filter(light -> !light.tag().hidden())
                .map(light -> light.withTag(Tag.NONE))
                .toList();
        return scene.withLights(lights.isEmpty() ? Lights.of(scene.lights().first()) : new Lights(lights))
                .withSpheres(scene.spheres().stream()
                        .filter(sphere -> !sphere.tag().hidden())
                        .map(sphere -> sphere.withTag(Tag.NONE))
                        .toList())
                .withMeshes(scene.meshes().stream()
                        .filter(mesh -> !mesh.tag().hidden())
                        .map(mesh -> mesh.withTag(Tag.NONE))
                        .toList())
                .withTracks(scene.tracks().stream()
                        .flatMap(track -> target(scene, track.target()).map(track::withTarget).stream())
                        .toList());
    }

    private static Optional<TrackTarget> target(Scene scene, TrackTarget target) {
        List<Tag> tags = switch (target.kind()) {
            case LIGHT -> scene.lights().list().stream().map(Light::tag).toList();
            case SPHERE -> scene.spheres().stream().map(Sphere::tag).toList();
            case MESH -> scene.meshes().stream().map(Mesh::tag).toList();
            case CAMERA, PLANE, SKY, SHADING, RENDERING -> List.of();
        };
        if (!target.kind().isListed() || target.index() >= tags.size()) {
            return Optional.of(target);
        }
        long before =
                tags.subList(0, target.index()).stream().filter(Tag::hidden).count();
        return Optional.of(new TrackTarget(target.kind(), target.index() - (int) before))
                .filter(_ -> !tags.get(target.index()).hidden());
    }
}
