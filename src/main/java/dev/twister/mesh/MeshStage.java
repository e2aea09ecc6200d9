package dev.twister.mesh;

import dev.twister.mesh.FileSurroundings.FileCamera;
import dev.twister.mesh.FileSurroundings.FileLight;
import dev.twister.mesh.input.QuotedText;
import dev.twister.scene.Camera;
import dev.twister.scene.CameraKeyframe;
import dev.twister.scene.Easing;
import dev.twister.scene.Geometry;
import dev.twister.scene.Ground;
import dev.twister.scene.Keyframe;
import dev.twister.scene.Light;
import dev.twister.scene.Mesh;
import dev.twister.scene.MeshAnimation;
import dev.twister.scene.Rendering;
import dev.twister.scene.Rgb;
import dev.twister.scene.Scene;
import dev.twister.scene.Track;
import dev.twister.scene.TrackTarget;
import dev.twister.scene.Vector3;
import dev.twister.scene.light.LightShape;
import dev.twister.scene.light.Lights;
import dev.twister.scene.property.LightProperties;
import dev.twister.scene.property.SceneLimits;
import dev.twister.scene.select.Title;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.function.Function;

/** A scene for viewing one mesh: scaled to 2 meters, on the checkered plane, in the center of the picture. */
public final class MeshStage {
    /** Smoothing angle for files without normals. */
    public static final double SMOOTH_DEGREES = 30;

    private static final double LARGEST_SIDE = 2;
    private static final double PLANE_SIZE = 20;

    /** Below the mesh, whose own flat bottom is seen, not the plane; a thousandth of the largest side. */
    private static final double PLANE_HEIGHT = -LARGEST_SIDE / 1000;

    /** Few, because each sample traverses the triangles, and the picture at rest is refined. */
    private static final int SHADOW_SAMPLES = 16;

    /** Of a file with glass: through both walls of a vessel, to what is in it or behind it, and to the light. */
    private static final int GLASS_BOUNCES = 8;

    private static final double YAW_DEGREES = 20;
    private static final double PITCH_DEGREES = 15;
    private static final double FIELD_OF_VIEW_DEGREES = 40;

    /** Factor for the distance at which the mesh's bounding sphere just fits into the picture. */
    private static final double ROOM = 1.05;

    /** How many times of an animation its bounds are of. */
    private static final double POSES_PER_SECOND = 20;

    private static final double MOST_POSES = 60;

    private static final Rgb BRIGHT = new Rgb(0.8, 0.8, 0.8);
    private static final Rgb DARK = new Rgb(0.35, 0.35, 0.35);
    private static final Vector3 LAMP = new Vector3(-3, 6, -4);

    /** What the lamp adds at least to the light of a sky, for shadows and highlights. */
    private static final double LEAST_PART = 0.1;

    /** Light of the day sky on a surface that faces up, under which the window opens a mesh. */
    private static final double DAY = 0.81;

    private MeshStage() {}

    /**
     * The scene under another sky: with path tracing, the stage's own lamp adds what the sky's light lacks for the
     * brightness that the ground has without path tracing.
     *
     * @param sky the luminance of a white surface that faces up, under the sky alone
     */
    public static Scene under(double sky, Scene scene) {
        return scene.lights().equals(Lights.of(lamp(DAY))) ? scene.withLights(Lights.of(lamp(sky))) : scene;
    }

    private static Light lamp(double sky) {
        double squared = LAMP.dot(LAMP);
        double lit = LAMP.y() / Math.sqrt(squared);
        double part = Math.max(1 - sky / lit, LEAST_PART);
        return Light.of(LAMP, 0.5, new Rgb(1, 1, 1)).withStrength(part * squared);
    }

    /** Default file for saving a mesh's scene: beside the mesh. */
    public static Path sceneFile(Path mesh) {
        String name = mesh.getFileName().toString();
        int dot = name.lastIndexOf('.');
        return mesh.toAbsolutePath().resolveSibling((dot > 0 ? name.substring(0, dot) : name) + ".json");
    }

    /**
     * The scene for a mesh. The lights of the file replace the stage's own, its cameras are views.
     *
     * @param source the mesh file
     * @param held its content
     * @param skybox the panorama's file
     * @param pose how the mesh stands, and which of its animations it plays
     * @throws MeshException if the mesh cannot be scaled so far
     */
    public static Scene of(Geometry.OfFile source, MeshFile held, Path skybox, MeshPose pose) {
        Path file = source.path();
        Mesh turned = Mesh.of(source).withRotation(pose.rotation(file)).withAnimation(pose.animation(file, held));
        Box bounds = bounds(turned, held);
        Vector3 half = bounds.half();
        double largest = 2 * Math.max(half.x(), Math.max(half.y(), half.z()));
        double scale = LARGEST_SIDE / largest;
        if (!(scale >= SceneLimits.FACTOR.min() && scale <= SceneLimits.FACTOR.max())) {
            throw new MeshException(QuotedText.path(file) + ": the mesh is " + (float) largest + " m wide; expected "
                    + LARGEST_SIDE / SceneLimits.FACTOR.max() + " to " + LARGEST_SIDE / SceneLimits.FACTOR.min()
                    + " m; scale it in a scene file or in the program that made it");
        }
        Vector3 center = bounds.center();
        Vector3 place = new Vector3(center.x(), bounds.least().y(), center.z()).times(-scale);
        double radius = scale * half.length();
        double distance = ROOM * radius / Math.sin(Math.toRadians(FIELD_OF_VIEW_DEGREES / 2));
        double yaw = Math.toRadians(YAW_DEGREES);
        double pitch = Math.toRadians(PITCH_DEGREES);
        Vector3 eye = new Vector3(
                -distance * Math.sin(yaw) * Math.cos(pitch),
                scale * half.y() + distance * Math.sin(pitch),
                -distance * Math.cos(yaw) * Math.cos(pitch));
        Mesh mesh = turned.withScale(scale).withPosition(place).withSmoothDegrees(SMOOTH_DEGREES);
        Moving moving = new Moving(mesh, held);
        FileSurroundings around = moving.at(mesh.animation());
        StageLights lights = new StageLights(new Vector3(0, scale * half.y(), 0), LARGEST_SIDE / 2);
        return Scene.under(skybox)
                .withTitle(Title.NONE.withName(file.getFileName().toString()))
                .withCamera(Camera.of(eye, YAW_DEGREES, PITCH_DEGREES, FIELD_OF_VIEW_DEGREES))
                .withViews(around.cameras().stream().map(FileCamera::view).toList())
                .withLights(around.lights().isEmpty() ? Lights.of(lamp(DAY)) : lights.of(around.lights(), scale))
                .withTracks(moving.tracks())
                .withRendering(
                        Rendering.DEFAULT.withShadowSamples(SHADOW_SAMPLES).withBounces(bounces(held)))
                .withGround(Ground.of(PLANE_SIZE, PLANE_HEIGHT, BRIGHT, DARK, 0))
                .withMeshes(List.of(mesh));
    }

    private static int bounces(MeshFile held) {
        boolean glass = held.parts().stream().anyMatch(part -> part.material().transmission() > 0);
        return glass ? GLASS_BOUNCES : Rendering.DEFAULT.bounces();
    }

    /**
     * How a camera of the file moves in one turn of the animation; empty if it rests, or is not there.
     *
     * @param stage as {@link #of} made it
     * @param view the camera's name
     */
    public static List<CameraKeyframe> path(Scene stage, MeshFile held, String view) {
        return new Moving(stage.meshes().getFirst(), held).path(view);
    }

    /** The lights and cameras of a file in the mesh's animation. */
    private record Moving(Mesh mesh, MeshFile held) {
        private static final double KEYFRAMES_PER_SECOND = 30;
        private static final double MOST_KEYFRAMES = 1000;
        private static final double TURN = 360;

        /** In the scene's coordinates, at the start of an animation. */
        FileSurroundings at(MeshAnimation animation) {
            return held.surroundings(animation).placed(MeshPlacement.of(mesh));
        }

        /** At evenly spread times, by their seconds. */
        private SortedMap<Double, FileSurroundings> turn() {
            double seconds = held.clipSeconds(mesh.animation());
            int steps = (int) Math.clamp(Math.ceil(seconds * KEYFRAMES_PER_SECOND), 1, MOST_KEYFRAMES);
            SortedMap<Double, FileSurroundings> turn = new TreeMap<>();
            for (int step = 0; step <= steps; step++) {
                double time = seconds * step / steps;
                turn.put(time, at(mesh.animation().withLoop(false).withStart(time)));
            }
            return turn;
        }

        /** Of the places and directions of lights that move. */
        List<Track> tracks() {
            if (held.surroundings().lights().isEmpty() || held.clipSeconds(mesh.animation()) == 0) {
                return List.of();
            }
            SortedMap<Double, FileSurroundings> turn = turn();
            List<Track> tracks = new ArrayList<>();
            for (int i = 0; i < held.surroundings().lights().size(); i++) {
                int index = i;
                LightShape.Kind kind =
                        held.surroundings().lights().get(i).shape().kind();
                if (kind != LightShape.Kind.SUN) {
                    track(index, "position", turn, light -> SceneLimits.POSITION.clamp(light.position()))
                            .ifPresent(tracks::add);
                }
                if (kind != LightShape.Kind.SPHERE) {
                    track(index, "direction", turn, light -> light.shape().direction())
                            .ifPresent(tracks::add);
                }
            }
            return tracks;
        }

        private Optional<Track> track(
                int light,
                String property,
                SortedMap<Double, FileSurroundings> turn,
                Function<FileLight, Vector3> value) {
            List<Keyframe> keyframes = turn.entrySet().stream()
                    .map(entry -> Keyframe.of(
                                    entry.getKey(),
                                    value.apply(entry.getValue().lights().get(light)))
                            .withEasing(Easing.LINEAR))
                    .toList();
            boolean moves = keyframes.stream().map(Keyframe::value).distinct().count() > 1;
            return Optional.of(new Track(
                            TrackTarget.light(light),
                            property,
                            keyframes,
                            mesh.animation().loop()))
                    .filter(_ -> moves);
        }

        List<CameraKeyframe> path(String view) {
            List<CameraKeyframe> path = new ArrayList<>();
            turn().forEach((seconds, around) -> around.cameras().stream()
                    .filter(camera -> camera.name().equals(view))
                    .forEach(camera -> {
                        Camera now = camera.view().camera();
                        double before = path.isEmpty() ? 0 : path.getLast().yawDegrees();
                        // The short way around.
                        double yaw = now.yawDegrees() - TURN * Math.rint((now.yawDegrees() - before) / TURN);
                        path.add(new CameraKeyframe(
                                seconds,
                                SceneLimits.POSITION.clamp(now.position()),
                                yaw,
                                now.pitchDegrees(),
                                Optional.empty(),
                                Optional.empty()));
                    }));
            boolean moves =
                    path.stream().map(key -> key.withSeconds(0)).distinct().count() > 1;
            return moves ? path : List.of();
        }
    }

    /** The box around all that the mesh is in its animation. */
    private static Box bounds(Mesh mesh, MeshFile held) {
        Affine placement = MeshPlacement.of(mesh);
        double seconds = held.clipSeconds(mesh.animation());
        if (seconds == 0) {
            return held.posed(mesh.animation()).bounds(placement);
        }
        int poses = (int) Math.clamp(seconds * POSES_PER_SECOND, 1, MOST_POSES);
        Box bounds = Box.NONE;
        for (int pose = 0; pose <= poses; pose++) {
            MeshAnimation now = mesh.animation().withLoop(false).withStart(seconds * pose / poses);
            Box box = held.posed(now).bounds(placement);
            bounds = bounds.with(box.least()).with(box.largest());
        }
        return bounds;
    }

    /** The lights of a file, which have no size: near ones as small balls around its mesh. */
    private static final class StageLights {
        /** Radius of a near light, as a part of the mesh's. */
        private static final double SMALL = 0.002;

        private final Vector3 center;
        private final double radius;

        /** A light, and the direction from the mesh's center to it. */
        private record Placed(Light light, Vector3 toLight) {}

        /**
         * @param center of the mesh
         * @param radius half of the mesh's largest side
         */
        StageLights(Vector3 center, double radius) {
            this.center = center;
            this.radius = radius;
        }

        /**
         * The lights of a scene. Where they would light the center more brightly than white, all are dimmed by the same
         * factor: files do not say for which exposure their lights are.
         *
         * @param lights at least one, in the scene's coordinates
         * @param scale meters in the scene per meter of the file
         */
        Lights of(List<FileLight> lights, double scale) {
            List<Placed> placed =
                    lights.stream().map(light -> placed(light, scale)).toList();
            double dimmed = 1 / Math.max(1, brightest(placed));
            List<Light> used = new ArrayList<>();
            for (Placed one : placed) {
                Light light = one.light();
                Light dim = light.withShare(LightProperties.SHARE.range().clamp(dimmed * light.share()));
                used.add(light.strength()
                        .map(strength -> dim.withStrength(
                                LightProperties.STRENGTH.range().clamp(dimmed * strength)))
                        .orElse(dim));
            }
            return new Lights(used);
        }

        private Placed placed(FileLight light, double scale) {
            boolean sun = light.shape().kind() == LightShape.Kind.SUN;
            Vector3 place = light.position().minus(center);
            double distance = sun ? 1 : Math.max(place.length(), radius);
            // A white surface at the distance of 1 m has this radiance; distances are scaled, and light at the mesh is
            // not.
            double strength = light.intensity() / Math.PI * (sun ? 1 : scale * scale);
            double share = luminance(light.color()) * strength / (distance * distance);
            Light used = Light.of(SceneLimits.POSITION.clamp(light.position()), SMALL * radius, light.color())
                    .withShape(light.shape())
                    .withStrength(strength)
                    .withShare(share);
            Vector3 toNear = place.length() > 0 ? place.normalized() : place;
            return new Placed(used, sun ? light.shape().toward() : toNear);
        }

        /** How brightly a white surface at the center is lit that faces the light from whose side it is lit most. */
        private static double brightest(List<Placed> lights) {
            double brightest = 0;
            for (Placed faced : lights) {
                double sum = 0;
                for (Placed other : lights) {
                    sum += other.light().share() * Math.max(0, faced.toLight().dot(other.toLight()));
                }
                brightest = Math.max(brightest, sum);
            }
            return brightest;
        }

        private static double luminance(Rgb color) {
            return 0.2126 * color.red() + 0.7152 * color.green() + 0.0722 * color.blue();
        }
    }
}
