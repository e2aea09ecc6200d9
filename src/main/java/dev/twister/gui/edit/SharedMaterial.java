package dev.twister.gui.edit;

import dev.twister.scene.Material;
import dev.twister.scene.Mesh;
import dev.twister.scene.Scene;
import dev.twister.scene.Sphere;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.SequencedMap;
import java.util.function.UnaryOperator;

/**
 * A scene's named material and the bodies that use it. The bodies stay the same during an edit, even if the material
 * equals another one in between.
 *
 * @param bodies by their {@link BodyNumber}
 */
public record SharedMaterial(String name, List<Integer> bodies) {
    public SharedMaterial {
        bodies = List.copyOf(bodies);
    }

    /** The named material of a body; empty if the body has a material of its own. */
    public static Optional<SharedMaterial> of(Scene scene, int body) {
        Material material = BodyMaterials.of(scene, body);
        return scene.materials().entrySet().stream()
                .filter(named -> named.getValue().equals(material))
                .map(Map.Entry::getKey)
                .findFirst()
                .map(name -> new SharedMaterial(name, bodies(scene, material)));
    }

    private static List<Integer> bodies(Scene scene, Material material) {
        List<Integer> bodies = new ArrayList<>();
        if (scene.ground().material().equals(material)) {
            bodies.add(BodyNumber.PLANE);
        }
        for (int i = 0; i < scene.spheres().size(); i++) {
            if (scene.spheres().get(i).material().equals(material)) {
                bodies.add(BodyNumber.ofSphere(i));
            }
        }
        for (int i = 0; i < scene.meshes().size(); i++) {
            if (scene.meshes().get(i).material().filter(material::equals).isPresent()) {
                bodies.add(BodyNumber.ofMesh(i));
            }
        }
        return bodies;
    }

    /** Whether the bodies still use the material. */
    public boolean isIn(Scene scene) {
        return Optional.ofNullable(scene.materials().get(name))
                .filter(material -> bodies.stream()
                        .allMatch(body -> BodyMaterials.has(scene, body)
                                && BodyMaterials.of(scene, body).equals(material)))
                .isPresent();
    }

    /** The scene with the material changed for all of the bodies. */
    public Scene edited(Scene scene, UnaryOperator<Material> edit) {
        Material material = edit.apply(scene.materials().get(name));
        SequencedMap<String, Material> materials = new LinkedHashMap<>(scene.materials());
        materials.put(name, material);
        List<Sphere> spheres = new ArrayList<>(scene.spheres());
        List<Mesh> meshes = new ArrayList<>(scene.meshes());
        for (int body : bodies) {
            if (BodyEdits.isMesh(scene, body)) {
                int index = BodyNumber.mesh(body);
                meshes.set(index, meshes.get(index).withMaterial(material));
            } else if (body != BodyNumber.PLANE) {
                int index = BodyNumber.sphere(body);
                spheres.set(index, spheres.get(index).withMaterial(material));
            }
        }
        Scene edited = scene.withMaterials(materials).withSpheres(spheres).withMeshes(meshes);
        return bodies.contains(BodyNumber.PLANE)
                ? edited.withGround(scene.ground().withMaterial(material))
                : edited;
    }
}
