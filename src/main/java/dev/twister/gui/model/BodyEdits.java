package dev.twister.gui.model;

import dev.twister.scene.Body;
import dev.twister.scene.Lights;
import dev.twister.scene.Mesh;
import dev.twister.scene.Pour;
import dev.twister.scene.Scene;
import dev.twister.scene.Sphere;
import dev.twister.scene.Vector3;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.BiFunction;
import java.util.function.UnaryOperator;
import java.util.stream.IntStream;
import java.util.stream.Stream;

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

    /** Whether the body can be selected: an editable one, or a sphere that is poured. */
    public static boolean isSelectable(Scene scene, int body) {
        return isEditable(scene, body) || isPoured(scene, body);
    }

    /** Whether the body can be taken and moved: the light, the spheres and the meshes. */
    public static boolean isMovable(Scene scene, int body) {
        return body == BodyNumber.LIGHT || isSolid(scene, body);
    }

    /**
     * Whether a number may mean another body in the other scene: one of its kind has come or gone. There are always one
     * light and one plane.
     *
     * @param body of the first scene
     */
    public static boolean isRenumbered(Scene scene, Scene other, int body) {
        return isMesh(scene, body)
                ? scene.meshes().size() != other.meshes().size()
                : BodyNumber.sphere(body) >= 0
                        && scene.spheres().size() != other.spheres().size();
    }

    /**
     * The body that number of steps on in the round of nothing, the light, the plane, all spheres and all meshes in
     * their order.
     *
     * @param body where the cycle starts: {@link BodyNumber#NONE} or an editable body
     * @param steps backward if negative
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

    /** All movable bodies: the light, the spheres and the meshes in the scene's order. */
    public static List<Integer> movable(Scene scene) {
        return Stream.of(
                        IntStream.of(BodyNumber.LIGHT),
                        IntStream.range(0, scene.spheres().size()).map(BodyNumber::ofSphere),
                        IntStream.range(0, scene.meshes().size()).map(BodyNumber::ofMesh))
                .flatMapToInt(numbers -> numbers)
                .boxed()
                .toList();
    }

    public static Sphere sphere(Scene scene, int body) {
        return scene.spheres().get(BodyNumber.sphere(body));
    }

    public static Mesh mesh(Scene scene, int body) {
        return scene.meshes().get(BodyNumber.mesh(body));
    }

    /** The body that {@link #isSolid} is asked about. */
    public static Body solid(Scene scene, int body) {
        return isMesh(scene, body) ? mesh(scene, body) : sphere(scene, body);
    }

    /** The place of a movable body: the center of the light or a sphere, the origin of a mesh's file. */
    public static Vector3 position(Scene scene, int body) {
        return body == BodyNumber.LIGHT
                ? scene.lights().first().position()
                : solid(scene, body).position();
    }

    /** The scene with a movable body elsewhere. */
    public static Scene moved(Scene scene, int body, Vector3 position) {
        return moved(scene, Map.of(body, position));
    }

    /** The scene with movable bodies elsewhere. */
    static Scene moved(Scene scene, Map<Integer, Vector3> positions) {
        Scene moved = edited(
                scene,
                positions.keySet(),
                (body, sphere) -> sphere.withPosition(positions.get(body)),
                (body, mesh) -> mesh.withPosition(positions.get(body)));
        return positions.containsKey(BodyNumber.LIGHT)
                ? moved.withLights(Lights.of(scene.lights().first().withPosition(positions.get(BodyNumber.LIGHT))))
                : moved;
    }

    /** The numbers of the last bodies of a scene, which were added in this order. */
    public static List<Integer> numbersOfLast(Scene scene, List<Body> added) {
        int meshes = (int) added.stream().filter(Mesh.class::isInstance).count();
        int sphere = scene.spheres().size() - (added.size() - meshes);
        int mesh = scene.meshes().size() - meshes;
        List<Integer> numbers = new ArrayList<>();
        for (Body body : added) {
            switch (body) {
                case Sphere _ -> numbers.add(BodyNumber.ofSphere(sphere++));
                case Mesh _ -> numbers.add(BodyNumber.ofMesh(mesh++));
            }
        }
        return numbers;
    }

    /** The scene without a sphere or a mesh. */
    public static Scene deleted(Scene scene, int body) {
        return deleted(scene, Set.of(body));
    }

    /** The scene without those spheres and meshes. */
    public static Scene deleted(Scene scene, Set<Integer> bodies) {
        List<Sphere> spheres = new ArrayList<>();
        for (int index = 0; index < scene.spheres().size(); index++) {
            if (!bodies.contains(BodyNumber.ofSphere(index))) {
                spheres.add(scene.spheres().get(index));
            }
        }
        List<Mesh> meshes = new ArrayList<>();
        for (int index = 0; index < scene.meshes().size(); index++) {
            if (!bodies.contains(BodyNumber.ofMesh(index))) {
                meshes.add(scene.meshes().get(index));
            }
        }
        return scene.withSpheres(spheres).withMeshes(meshes);
    }

    /** The scene with changes of those of the bodies that are spheres or meshes, each told its body's number. */
    static Scene edited(
            Scene scene,
            Set<Integer> bodies,
            BiFunction<Integer, Sphere, Sphere> ofSphere,
            BiFunction<Integer, Mesh, Mesh> ofMesh) {
        List<Sphere> spheres = new ArrayList<>(scene.spheres());
        List<Mesh> meshes = new ArrayList<>(scene.meshes());
        boolean anySphere = false;
        boolean anyMesh = false;
        for (int body : bodies) {
            if (isMesh(scene, body)) {
                anyMesh = true;
                meshes.set(BodyNumber.mesh(body), ofMesh.apply(body, mesh(scene, body)));
            } else if (isSphere(scene, body)) {
                anySphere = true;
                spheres.set(BodyNumber.sphere(body), ofSphere.apply(body, sphere(scene, body)));
            }
        }
        // A list that stays the same one is compared at once, however long it is.
        Scene edited = anySphere ? scene.withSpheres(spheres) : scene;
        return anyMesh ? edited.withMeshes(meshes) : edited;
    }

    static Scene editedSphere(Scene scene, int body, UnaryOperator<Sphere> edit) {
        return edited(scene, Set.of(body), (_, sphere) -> edit.apply(sphere), (_, mesh) -> mesh);
    }

    static Scene editedMesh(Scene scene, int body, UnaryOperator<Mesh> edit) {
        return edited(scene, Set.of(body), (_, sphere) -> sphere, (_, mesh) -> edit.apply(mesh));
    }
}
