package dev.twister.gui.edit;

import dev.twister.scene.Material;
import dev.twister.scene.Mesh;
import dev.twister.scene.Scene;
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
}
