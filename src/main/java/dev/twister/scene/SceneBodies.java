package dev.twister.scene;

import java.util.List;
import java.util.stream.Stream;

/**
 * The list of a scene's bodies, in the order of their numbers: the spheres, then the meshes.
 *
 * @param spheres those that are there from the start
 */
public record SceneBodies(List<Sphere> spheres, List<Mesh> meshes) {
    public static final SceneBodies NONE = new SceneBodies(List.of(), List.of());

    public SceneBodies {
        spheres = List.copyOf(spheres);
        meshes = List.copyOf(meshes);
    }

    public Stream<Body> stream() {
        return Stream.concat(spheres.stream(), meshes.stream());
    }

    public SceneBodies withSpheres(List<Sphere> newSpheres) {
        return new SceneBodies(newSpheres, meshes);
    }

    public SceneBodies withMeshes(List<Mesh> newMeshes) {
        return new SceneBodies(spheres, newMeshes);
    }
}
