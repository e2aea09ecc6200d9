package dev.twister.gui.model;

import dev.twister.scene.Mesh;
import dev.twister.scene.Pour;
import dev.twister.scene.Scene;
import dev.twister.scene.Sphere;
import dev.twister.scene.Vector3;
import java.util.ArrayList;
import java.util.List;
import java.util.function.UnaryOperator;

/** Edits of a scene's bodies, by their {@link BodyNumber}. */
public final class BodyEdits {
    private BodyEdits() {}

    /** Whether a scene has a sphere of that number. */
    public static boolean isSphere(Scene scene, int body) {
        int index = BodyNumber.sphere(body);
        return index >= 0 && index < scene.spheres().size();
    }

    /** Whether a scene has a mesh of that number. */
    public static boolean isMesh(Scene scene, int body) {
        int index = BodyNumber.mesh(body);
        return index >= 0 && index < scene.meshes().size();
    }

    /** Whether it is a body that can be copied and deleted: a sphere or a mesh. */
    public static boolean isSolid(Scene scene, int body) {
        return isSphere(scene, body) || isMesh(scene, body);
    }

    /** Whether it is a sphere that comes while bodies move, and can be looked at, but not edited. */
    public static boolean isPoured(Scene scene, int body) {
        int index = BodyNumber.sphere(body) - scene.spheres().size();
        return index >= 0 && index < scene.pour().map(Pour::count).orElse(0);
    }

    /** Whether the body can be selected and edited: the light, the plane, the spheres and the meshes. */
    public static boolean isEditable(Scene scene, int body) {
        return body == BodyNumber.LIGHT || body == BodyNumber.PLANE || isSolid(scene, body);
    }

    /** Whether the body can be taken and moved: the light, the spheres and the meshes. */
    public static boolean isMovable(Scene scene, int body) {
        return body == BodyNumber.LIGHT || isSolid(scene, body);
    }

    /**
     * Whether a number may mean another body in the other scene: one of its kind has come or gone.
     *
     * @param body of the first scene
     */
    public static boolean isRenumbered(Scene scene, Scene other, int body) {
        return isMesh(scene, body)
                ? scene.meshes().size() != other.meshes().size()
                : scene.spheres().size() != other.spheres().size();
    }

    /**
     * The body that number of steps on in the round of nothing, the light, the plane, all spheres and all meshes in
     * their order.
     *
     * @param body where the round begins: {@link BodyNumber#NONE} or an editable body
     * @param steps back where they are negative
     */
    public static int along(Scene scene, int body, int steps) {
        int spheres = scene.spheres().size();
        // In the order of their numbers, of which that of nothing comes first.
        int firstMesh = BodyNumber.ofSphere(spheres) - BodyNumber.NONE;
        int from = !isEditable(scene, body)
                ? 0
                : isMesh(scene, body) ? firstMesh + BodyNumber.mesh(body) : body - BodyNumber.NONE;
        int to = Math.floorMod(from + steps, firstMesh + scene.meshes().size());
        return to < firstMesh ? BodyNumber.NONE + to : BodyNumber.ofMesh(to - firstMesh);
    }

    public static Sphere sphere(Scene scene, int body) {
        return scene.spheres().get(BodyNumber.sphere(body));
    }

    public static Mesh mesh(Scene scene, int body) {
        return scene.meshes().get(BodyNumber.mesh(body));
    }

    /** The body that {@link #isSolid} is asked about. */
    public static Solid solid(Scene scene, int body) {
        return isMesh(scene, body) ? new Solid.OfMesh(mesh(scene, body)) : new Solid.OfSphere(sphere(scene, body));
    }

    /** The place of a movable body: the center of the light or a sphere, the origin of a mesh's file. */
    public static Vector3 position(Scene scene, int body) {
        return body == BodyNumber.LIGHT
                ? scene.light().position()
                : solid(scene, body).position();
    }

    /** The scene with a movable body elsewhere. */
    public static Scene moved(Scene scene, int body, Vector3 position) {
        if (body == BodyNumber.LIGHT) {
            return scene.withLight(scene.light().withPosition(position));
        }
        return isMesh(scene, body)
                ? editedMesh(scene, body, mesh -> mesh.withPosition(position))
                : editedSphere(scene, body, sphere -> sphere.withPosition(position));
    }

    /** The scene without a sphere or a mesh. */
    public static Scene deleted(Scene scene, int body) {
        return isMesh(scene, body)
                ? scene.withMeshes(without(scene.meshes(), BodyNumber.mesh(body)))
                : scene.withSpheres(without(scene.spheres(), BodyNumber.sphere(body)));
    }

    static Scene editedSphere(Scene scene, int body, UnaryOperator<Sphere> edit) {
        return scene.withSpheres(with(scene.spheres(), BodyNumber.sphere(body), edit));
    }

    static Scene editedMesh(Scene scene, int body, UnaryOperator<Mesh> edit) {
        return scene.withMeshes(with(scene.meshes(), BodyNumber.mesh(body), edit));
    }

    private static <T> List<T> with(List<T> bodies, int index, UnaryOperator<T> edit) {
        List<T> edited = new ArrayList<>(bodies);
        edited.set(index, edit.apply(bodies.get(index)));
        return edited;
    }

    private static <T> List<T> without(List<T> bodies, int index) {
        List<T> fewer = new ArrayList<>(bodies);
        fewer.remove(index);
        return fewer;
    }
}
