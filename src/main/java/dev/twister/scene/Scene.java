package dev.twister.scene;

import dev.twister.scene.generate.Pour;
import dev.twister.scene.light.Lights;
import dev.twister.scene.property.Copied;
import dev.twister.scene.select.SceneBodies;
import dev.twister.scene.select.Title;
import java.nio.file.Path;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Optional;
import java.util.SequencedMap;
import java.util.stream.Stream;

/**
 * What a scene file says, as records of what changes together.
 *
 * @param views cameras to go to, each under a name of its own, in the order in which they are offered
 * @param materials those that bodies share by name, in the file's order; what a body has of one is in the body
 * @param physics how bodies move, where they do
 * @param pour spheres that come one after the other while bodies move
 * @param tracks what changes in a film besides the camera's place and what physics moves
 */
@Copied
public record Scene(
        Title title,
        Camera camera,
        List<CameraView> views,
        Lights lights,
        SequencedMap<String, Material> materials,
        Ground ground,
        SceneBodies bodies,
        Sky sky,
        Shading shading,
        Rendering rendering,
        Physics physics,
        Optional<Pour> pour,
        List<Track> tracks)
        implements SceneCopy.With {
    /** The newest version of the file format; the older ones are read too. */
    public static final int VERSION = 4;

    public Scene {
        materials = Collections.unmodifiableSequencedMap(new LinkedHashMap<>(materials));
        views = List.copyOf(views);
        tracks = List.copyOf(tracks);
    }

    /** An empty scene: the defaults, no name and no bodies. */
    public static Scene under(Path panorama) {
        return new Scene(
                Title.NONE,
                Camera.DEFAULT,
                List.of(),
                Lights.of(Light.DEFAULT),
                new LinkedHashMap<>(),
                Ground.DEFAULT,
                SceneBodies.NONE,
                Sky.of(panorama),
                Shading.DEFAULT,
                Rendering.DEFAULT,
                Physics.DEFAULT,
                Optional.empty(),
                List.of());
    }

    /** The spheres that are there from the start. */
    public List<Sphere> spheres() {
        return bodies.spheres();
    }

    public List<Mesh> meshes() {
        return bodies.meshes();
    }

    /** The spheres that are there from the start, then those that are poured, in the order in which they come. */
    public List<Sphere> allSpheres() {
        return pour.map(coming -> Stream.concat(spheres().stream(), coming.spheres().stream())
                        .toList())
                .orElse(spheres());
    }

    public Scene withSpheres(List<Sphere> spheres) {
        return withBodies(bodies.withSpheres(spheres));
    }

    public Scene withMeshes(List<Mesh> meshes) {
        return withBodies(bodies.withMeshes(meshes));
    }

    public Scene withPour(Pour newPour) {
        Optional<Pour> coming = Optional.of(newPour);
        return new Scene(
                title, camera, views, lights, materials, ground, bodies, sky, shading, rendering, physics, coming,
                tracks);
    }

    /** Without the track of a property, if there is one. */
    public Scene withoutTrack(TrackTarget target, String property) {
        return withTracks(
                tracks.stream().filter(track -> !track.isOf(target, property)).toList());
    }
}
