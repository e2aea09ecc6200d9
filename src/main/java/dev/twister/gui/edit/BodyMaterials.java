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
import java.util.Set;
import java.util.function.UnaryOperator;

/** What a scene's plane, spheres and meshes are made of, by their {@link BodyNumber}. */
public final class BodyMaterials {
    private BodyMaterials() {}

    /** Whether it is a body to which the scene gives a material: the plane, a sphere, or a mesh with one of its own. */
    public static boolean has(Scene scene, int body) {
        return body == BodyNumber.PLANE
                || BodyEdits.isSphere(scene, body)
                || (BodyEdits.isMesh(scene, body)
                        && BodyEdits.mesh(scene, body).material().isPresent());
    }

    public static Material of(Scene scene, int body) {
        if (BodyEdits.isMesh(scene, body)) {
            return BodyEdits.mesh(scene, body).material().orElseThrow();
        }
        return body == BodyNumber.PLANE
                ? scene.ground().material()
                : BodyEdits.sphere(scene, body).material();
    }

    /** The scene with another material of that body alone. */
    public static Scene edited(Scene scene, int body, UnaryOperator<Material> edit) {
        return edited(scene, Set.of(body), edit);
    }

    /** The scene with other materials of those bodies; a body that has none stays as it is. */
    public static Scene edited(Scene scene, Set<Integer> bodies, UnaryOperator<Material> edit) {
        Scene edited = BodyEdits.edited(
                scene,
                bodies,
                (_, sphere) -> sphere.withMaterial(edit.apply(sphere.material())),
                (_, mesh) -> mesh.material().map(edit).map(mesh::withMaterial).orElse(mesh));
        return bodies.contains(BodyNumber.PLANE)
                ? edited.withGround(
                        scene.ground().withMaterial(edit.apply(scene.ground().material())))
                : edited;
    }

    /** The scene with that material of that body alone. */
    public static Scene with(Scene scene, int body, Material material) {
        if (BodyEdits.isMesh(scene, body)) {
            return BodyEdits.editedMesh(scene, body, mesh -> mesh.withMaterial(material));
        }
        return body == BodyNumber.PLANE
                ? scene.withGround(scene.ground().withMaterial(material))
                : BodyEdits.editedSphere(scene, body, sphere -> sphere.withMaterial(material));
    }

    /** The scene with a mesh that has the materials of its file again. */
    public static Scene withFiles(Scene scene, int body) {
        return BodyEdits.editedMesh(scene, body, Mesh::withoutMaterial);
    }

    /** Whether all materials, those of bodies and those that are shared, are the same in both scenes. */
    public static boolean areSame(Scene one, Scene other) {
        return one.spheres().equals(other.spheres())
                && one.meshes().equals(other.meshes())
                && one.ground().equals(other.ground())
                && one.materials().equals(other.materials());
    }

    /**
     * A scene's named material and the bodies that use it. The bodies stay the same during an edit, even if the
     * material equals another one in between.
     *
     * @param bodies by their {@link BodyNumber}
     */
    public record Shared(String name, List<Integer> bodies) {
        public Shared {
            bodies = List.copyOf(bodies);
        }

        /** The named material of a body; empty if the body has a material of its own. */
        public static Optional<Shared> of(Scene scene, int body) {
            Material material = BodyMaterials.of(scene, body);
            return scene.materials().entrySet().stream()
                    .filter(named -> named.getValue().equals(material))
                    .map(Map.Entry::getKey)
                    .findFirst()
                    .map(name -> new Shared(name, bodies(scene, material)));
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
}
