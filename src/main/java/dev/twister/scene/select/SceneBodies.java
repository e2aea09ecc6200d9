package dev.twister.scene.select;

import dev.twister.scene.Body;
import dev.twister.scene.Mesh;
import dev.twister.scene.Sphere;
import dev.twister.scene.property.Copied;
import java.util.ArrayList;
import java.util.List;

/**
 * The list of a scene's bodies, in the order of their numbers: the spheres, then the meshes.
 *
 * @param spheres those that are there from the start
 */
@Copied
public record SceneBodies(List<Sphere> spheres, List<Mesh> meshes) implements SceneBodiesCopy.With {
    public static final SceneBodies NONE = new SceneBodies(List.of(), List.of());

    public SceneBodies {
        spheres = List.copyOf(spheres);
        meshes = List.copyOf(meshes);
    }

    /** With more bodies, each after those of its kind. */
    public SceneBodies with(List<Body> more) {
        List<Sphere> allSpheres = new ArrayList<>(spheres);
        List<Mesh> allMeshes = new ArrayList<>(meshes);
        for (Body body : more) {
            switch (body) {
                case Sphere sphere -> allSpheres.add(sphere);
                case Mesh mesh -> allMeshes.add(mesh);
            }
        }
        return new SceneBodies(allSpheres, allMeshes);
    }

    /** With another sphere at an index. */
    public SceneBodies withSphere(int index, Sphere sphere) {
        List<Sphere> changed = new ArrayList<>(spheres);
        changed.set(index, sphere);
        return withSpheres(changed);
    }

    /** With another mesh at an index. */
    public SceneBodies withMesh(int index, Mesh mesh) {
        List<Mesh> changed = new ArrayList<>(meshes);
        changed.set(index, mesh);
        return withMeshes(changed);
    }
}
