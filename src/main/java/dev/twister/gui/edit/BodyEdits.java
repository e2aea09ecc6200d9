package dev.twister.gui.edit;

import dev.twister.scene.Body;
import dev.twister.scene.Light;
import dev.twister.scene.Mesh;
import dev.twister.scene.Scene;
import dev.twister.scene.Sphere;
import dev.twister.scene.TrackTarget;
import dev.twister.scene.Vector3;
import dev.twister.scene.generate.Pour;
import dev.twister.scene.light.LightShape;
import dev.twister.scene.light.Lights;
import dev.twister.scene.property.SceneLimits;
import dev.twister.world.SceneMeshes;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.BiFunction;
import java.util.function.UnaryOperator;
import java.util.stream.IntStream;
import java.util.stream.Stream;

/** Edits of a scene's bodies, by their {@link BodyNumber}. */
public final class BodyEdits {
    /** In meters. */
    private static final double SUN_HANDLES = 1;

    private BodyEdits() {}

    /** Whether a scene has a light of that number. */
    public static boolean isLight(Scene scene, int body) {
        int index = BodyNumber.light(body);
        return index >= 0 && index < scene.lights().count();
    }

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

    /** Whether the body can be selected and edited: the lights, the plane, the spheres and the meshes. */
    public static boolean isEditable(Scene scene, int body) {
        return isLight(scene, body) || body == BodyNumber.PLANE || isSolid(scene, body);
    }

    /** Whether the body can be selected: an editable one, or a sphere that is poured. */
    public static boolean isSelectable(Scene scene, int body) {
        return isEditable(scene, body) || isPoured(scene, body);
    }

    /** Whether the body can be taken and moved: the lights, the spheres and the meshes. */
    public static boolean isMovable(Scene scene, int body) {
        return isLight(scene, body) || isSolid(scene, body);
    }

    /**
     * Whether a number may mean another body in the other scene: one of its kind has come or gone.
     *
     * @param body of the first scene
     */
    public static boolean isRenumbered(Scene scene, Scene other, int body) {
        if (isMesh(scene, body)) {
            return scene.meshes().size() != other.meshes().size();
        }
        return isLight(scene, body)
                ? scene.lights().count() != other.lights().count()
                : BodyNumber.sphere(body) >= 0
                        && scene.spheres().size() != other.spheres().size();
    }

    /** Whether bodies of some kind have come or gone. */
    public static boolean haveOtherCounts(Scene one, Scene other) {
        return one.lights().count() != other.lights().count()
                || one.spheres().size() != other.spheres().size()
                || one.meshes().size() != other.meshes().size();
    }

    /**
     * The body that number of steps on in the round of nothing, all lights, the plane, all spheres and all meshes in
     * their order.
     *
     * @param body where the cycle starts: {@link BodyNumber#NONE} or an editable body
     * @param steps backward if negative
     */
    public static int along(Scene scene, int body, int steps) {
        int plane = 1 + scene.lights().count();
        int firstMesh = plane + 1 + scene.spheres().size();
        int to = Math.floorMod(
                placeInRound(scene, body) + steps, firstMesh + scene.meshes().size());
        if (to == 0) {
            return BodyNumber.NONE;
        }
        if (to <= plane) {
            return to < plane ? BodyNumber.ofLight(to - 1) : BodyNumber.PLANE;
        }
        return to < firstMesh ? BodyNumber.ofSphere(to - plane - 1) : BodyNumber.ofMesh(to - firstMesh);
    }

    private static int placeInRound(Scene scene, int body) {
        int plane = 1 + scene.lights().count();
        if (!isEditable(scene, body)) {
            return 0;
        }
        if (isLight(scene, body)) {
            return 1 + BodyNumber.light(body);
        }
        return isMesh(scene, body)
                ? plane + 1 + scene.spheres().size() + BodyNumber.mesh(body)
                : plane + body - BodyNumber.PLANE;
    }

    /** Whether the body is moved and deleted with others: a movable one that is not locked. */
    public static boolean isFree(Scene scene, int body) {
        return isMovable(scene, body) && !TagEdits.of(scene, body).locked();
    }

    /** All bodies that are neither hidden nor locked: lights, spheres and meshes in the scene's order. */
    public static List<Integer> movable(Scene scene) {
        return Stream.of(
                        IntStream.range(0, scene.lights().count()).map(BodyNumber::ofLight),
                        IntStream.range(0, scene.spheres().size()).map(BodyNumber::ofSphere),
                        IntStream.range(0, scene.meshes().size()).map(BodyNumber::ofMesh))
                .flatMapToInt(numbers -> numbers)
                .filter(body -> isFree(scene, body) && !TagEdits.of(scene, body).hidden())
                .boxed()
                .toList();
    }

    public static Light light(Scene scene, int body) {
        return scene.lights().get(BodyNumber.light(body));
    }

    /** The scene with another light in place of one. */
    public static Scene withLight(Scene scene, int body, Light light) {
        return scene.withLights(scene.lights().with(BodyNumber.light(body), light));
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

    /**
     * The place of a movable body: the center of a light or a sphere, the origin of a mesh's file. A sun has its
     * handles over the middle of the ground.
     */
    public static Vector3 position(Scene scene, int body) {
        if (!isLight(scene, body)) {
            return solid(scene, body).position();
        }
        Light light = light(scene, body);
        return light.isSun() ? new Vector3(0, scene.ground().height() + SUN_HANDLES, 0) : light.position();
    }

    /** Whether a body is a light that shines in a direction. */
    public static boolean isAimed(Scene scene, int body) {
        return isLight(scene, body) && light(scene, body).shape().kind() != LightShape.Kind.SPHERE;
    }

    /** The scene with a light that shines in another direction. */
    public static Scene aimed(Scene scene, int body, Vector3 direction) {
        Light light = light(scene, body);
        return withLight(scene, body, light.withShape(light.shape().withDirection(direction)));
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
        for (Map.Entry<Integer, Vector3> place : positions.entrySet()) {
            if (isLight(scene, place.getKey())) {
                Light light = light(scene, place.getKey()).withPosition(place.getValue());
                moved = withLight(moved, place.getKey(), light);
            }
        }
        return moved;
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

    /** The scene without a body. */
    public static Scene deleted(Scene scene, int body) {
        return deleted(scene, Set.of(body));
    }

    /** The scene without those lights, spheres and meshes; the first light stays where all are among them. */
    public static Scene deleted(Scene scene, Set<Integer> bodies) {
        List<Light> lights = new ArrayList<>();
        for (int index = 0; index < scene.lights().count(); index++) {
            if (!bodies.contains(BodyNumber.ofLight(index))) {
                lights.add(scene.lights().get(index));
            }
        }
        if (lights.isEmpty()) {
            lights.add(scene.lights().first());
        }
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
        Scene rest = scene.withSpheres(spheres)
                .withMeshes(meshes)
                .withTracks(TrackEdits.renumbered(scene.tracks(), target -> numberAfter(target, bodies)));
        // Lights that stay the same ones are compared at once.
        return lights.size() == scene.lights().count() ? rest : rest.withLights(new Lights(lights));
    }

    /** The target that a track has once bodies are deleted; empty if its own is among them. */
    private static Optional<TrackTarget> numberAfter(TrackTarget target, Set<Integer> deleted) {
        int body = BodyNumber.of(target);
        if (body == BodyNumber.NONE || body == BodyNumber.PLANE) {
            return Optional.of(target);
        }
        int before = (int) IntStream.range(0, target.index())
                .map(index -> BodyNumber.of(new TrackTarget(target.kind(), index)))
                .filter(deleted::contains)
                .count();
        return Optional.of(new TrackTarget(target.kind(), target.index() - before))
                .filter(_ -> !deleted.contains(body));
    }

    /**
     * Those of the bodies that can be deleted: spheres, meshes, and lights, but no locked ones and not the last light.
     */
    public static SelectedBodies deletable(Scene scene, SelectedBodies bodies) {
        long lights =
                bodies.bodies().stream().filter(body -> isLight(scene, body)).count();
        int kept = lights == scene.lights().count() ? BodyNumber.LIGHT : BodyNumber.NONE;
        return bodies.where(body -> isFree(scene, body) && body != kept);
    }

    /** Such as {@code light}, {@code sphere} or {@code mesh}. */
    public static String kind(Scene scene, int body) {
        return isLight(scene, body) ? "light" : solid(scene, body).kind();
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

    public static Scene editedSphere(Scene scene, int body, UnaryOperator<Sphere> edit) {
        return edited(scene, Set.of(body), (_, sphere) -> edit.apply(sphere), (_, mesh) -> mesh);
    }

    public static Scene editedMesh(Scene scene, int body, UnaryOperator<Mesh> edit) {
        return edited(scene, Set.of(body), (_, sphere) -> sphere, (_, mesh) -> edit.apply(mesh));
    }

    /**
     * The scene with spheres and meshes standing on the ground; lights, locked bodies and meshes that have not been
     * read stay.
     *
     * @param meshes of the scene
     */
    public static Scene onGround(Scene scene, SceneMeshes meshes, Set<Integer> bodies) {
        double ground = scene.ground().height();
        Map<Integer, Vector3> places = new LinkedHashMap<>();
        for (int body : bodies) {
            boolean unread = isMesh(scene, body) && !meshes.holds(mesh(scene, body));
            if (isSolid(scene, body) && isFree(scene, body) && !unread) {
                Vector3 now = position(scene, body);
                double lowest = lowest(scene, meshes, body);
                places.put(body, SceneLimits.POSITION.clamp(Axis.Y.with(now, now.y() + ground - lowest)));
            }
        }
        return moved(scene, places);
    }

    private static double lowest(Scene scene, SceneMeshes meshes, int body) {
        if (isSphere(scene, body)) {
            return position(scene, body).y() - sphere(scene, body).radius();
        }
        Mesh mesh = mesh(scene, body);
        return meshes.farPoints(mesh).stream()
                .mapToDouble(Vector3::y)
                .min()
                .orElse(mesh.position().y());
    }
}
