package dev.twister.world;

import dev.twister.scene.Mesh;
import dev.twister.scene.MeshAnimation;
import dev.twister.scene.Scene;
import dev.twister.scene.Track;
import dev.twister.scene.TrackTarget;
import dev.twister.scene.light.Lights;
import dev.twister.scene.property.CameraProperties;
import dev.twister.scene.property.LightProperties;
import dev.twister.scene.property.Property;
import dev.twister.scene.property.SceneProperties;
import dev.twister.scene.property.TrackProperties;
import dev.twister.world.animation.CameraPath;
import dev.twister.world.animation.TrackCurve;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;

/** A scene at a time of its film. */
public final class Animation {
    private static final double LOOP_TOLERANCE = 1e-9;

    private Animation() {}

    /** Whether anything moves by keyframes, or by an animation of a mesh's file. */
    public static boolean isIn(Scene scene) {
        return !scene.camera().keyframes().isEmpty() || !scene.tracks().isEmpty() || isOfMeshes(scene);
    }

    /** Whether an animation of a mesh's file is played. */
    public static boolean isOfMeshes(Scene scene) {
        return scene.meshes().stream().anyMatch(Animation::plays);
    }

    private static boolean plays(Mesh mesh) {
        return !mesh.animation().isNone() && mesh.animation().speed() != 0;
    }

    /**
     * The time of the last keyframe, or of the end of the longest animation of a mesh, in seconds; 0 where nothing
     * moves.
     *
     * @param meshes of the scene; the length of an animation of a mesh that is not among them is not known, and 0
     */
    public static double length(Scene scene, SceneMeshes meshes) {
        double camera = scene.camera().keyframes().isEmpty()
                ? 0
                : scene.camera().keyframes().getLast().seconds();
        return DoubleStream.concat(
                        scene.tracks().stream()
                                .mapToDouble(
                                        track -> track.keyframes().getLast().seconds()),
                        scene.meshes().stream().mapToDouble(mesh -> turn(mesh, meshes)))
                .reduce(camera, Math::max);
    }

    /** Seconds of the film that the animation of a mesh takes: once all of it, or what is left of it; 0 for none. */
    public static double turn(Mesh mesh, SceneMeshes meshes) {
        if (!plays(mesh)) {
            return 0;
        }
        MeshAnimation animation = mesh.animation();
        double length = meshes.clipSeconds(mesh);
        double start = animation.time(length);
        double left = animation.loop() ? length : animation.speed() > 0 ? length - start : start;
        return left / Math.abs(animation.speed());
    }

    /**
     * The number of frames of the whole film: up to its {@link #length}, or, in a film that loops, up to the frame
     * before it shows its first picture again.
     *
     * @param rate frames per second
     */
    public static int frames(Scene scene, SceneMeshes meshes, double rate) {
        double steps = length(scene, meshes) * rate;
        return loops(scene, meshes)
                ? Math.max(1, (int) Math.min(Integer.MAX_VALUE, Math.ceil(steps - LOOP_TOLERANCE * (1 + steps))))
                : (int) Math.min(Integer.MAX_VALUE - 1.0, Math.floor(steps + 0.5)) + 1;
    }

    /** Whether a track or an animation of a mesh begins again where it ends. */
    public static boolean repeats(Scene scene) {
        return scene.tracks().stream().anyMatch(Track::loop)
                || scene.meshes().stream()
                        .anyMatch(mesh -> plays(mesh) && mesh.animation().loop());
    }

    /** Whether something loops, and at the end everything is as at the start. */
    private static boolean loops(Scene scene, SceneMeshes meshes) {
        double end = length(scene, meshes);
        return repeats(scene)
                && scene.tracks().stream()
                        .allMatch(track -> areEqual(TrackCurve.at(track, 0), TrackCurve.at(track, end)))
                && scene.meshes().stream().filter(Animation::plays).allMatch(mesh -> turns(mesh, meshes, end))
                && CameraPath.at(scene.camera(), 0).equals(CameraPath.at(scene.camera(), end));
    }

    /** Whether the animation of a mesh is at a time as at the start. */
    private static boolean turns(Mesh mesh, SceneMeshes meshes, double end) {
        double length = meshes.clipSeconds(mesh);
        double turns = mesh.animation().speed() * end / length;
        return length == 0
                || (mesh.animation().loop() && Math.abs(turns - Math.rint(turns)) <= LOOP_TOLERANCE * (1 + turns));
    }

    /** Equal up to the rounding of a time after several turns. */
    private static boolean areEqual(List<Double> start, List<Double> end) {
        return IntStream.range(0, start.size())
                .allMatch(i -> Math.abs(start.get(i) - end.get(i)) <= LOOP_TOLERANCE * (1 + Math.abs(start.get(i))));
    }

    /**
     * The scene with the camera on its path, and all that has tracks as they say. The camera's tracks replace what its
     * keyframes say.
     *
     * @param seconds time since the start of the film
     */
    public static Scene at(Scene scene, double seconds) {
        return tracked(scene.withCamera(CameraPath.at(scene.camera(), seconds)), seconds);
    }

    /** The same with the camera where the scene has it, but for its tracks. */
    public static Scene tracked(Scene scene, double seconds) {
        return played(keyed(scene, seconds), seconds);
    }

    /** The scene whose meshes are as far in their animations as they are at a time. */
    public static Scene played(Scene scene, double seconds) {
        return isOfMeshes(scene) && seconds != 0
                ? scene.withMeshes(scene.meshes().stream()
                        .map(mesh -> mesh.withAnimation(mesh.animation().at(seconds)))
                        .toList())
                : scene;
    }

    /** The scene with all that has tracks as they say; the animations of its meshes begin where they do. */
    public static Scene keyed(Scene scene, double seconds) {
        Scene now = scene;
        List<Track> ofLights = new ArrayList<>();
        List<Track> ofSpheres = new ArrayList<>();
        List<Track> ofMeshes = new ArrayList<>();
        for (Track track : scene.tracks()) {
            switch (track.target().kind()) {
                case CAMERA -> now = now.withCamera(set(now.camera(), CameraProperties.ALL, track, seconds));
                case PLANE -> now = now.withGround(set(now.ground(), TrackProperties.PLANE, track, seconds));
                case SKY -> now = now.withSky(set(now.sky(), SceneProperties.SKY, track, seconds));
                case SHADING -> now = now.withShading(set(now.shading(), SceneProperties.SHADING, track, seconds));
                case RENDERING ->
                    now = now.withRendering(set(now.rendering(), SceneProperties.RENDERING, track, seconds));
                case LIGHT -> ofLights.add(track);
                case SPHERE -> ofSpheres.add(track);
                case MESH -> ofMeshes.add(track);
            }
        }
        // A list that stays the same one is compared at once, however long it is.
        if (!ofLights.isEmpty()) {
            now = now.withLights(new Lights(set(now.lights().list(), LightProperties.ALL, ofLights, seconds)));
        }
        if (!ofSpheres.isEmpty()) {
            now = now.withSpheres(set(now.spheres(), TrackProperties.SPHERE, ofSpheres, seconds));
        }
        return ofMeshes.isEmpty() ? now : now.withMeshes(set(now.meshes(), TrackProperties.MESH, ofMeshes, seconds));
    }

    private static <T> List<T> set(List<T> items, List<Property<T, ?>> properties, List<Track> tracks, double seconds) {
        List<T> changed = new ArrayList<>(items);
        for (Track track : tracks) {
            TrackTarget target = track.target();
            changed.set(target.index(), set(changed.get(target.index()), properties, track, seconds));
        }
        return changed.equals(items) ? items : changed;
    }

    private static <T> T set(T item, List<Property<T, ?>> properties, Track track, double seconds) {
        return properties.stream()
                .filter(property -> property.name().equals(track.property()))
                .findFirst()
                .map(property -> property.withNumbers(item, TrackCurve.at(track, seconds)))
                .orElse(item);
    }
}
