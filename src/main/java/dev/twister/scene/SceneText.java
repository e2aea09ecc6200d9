package dev.twister.scene;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import tools.jackson.core.io.JsonStringEncoder;

/** A scene as JSON text: fields in a fixed order, one line a part and one line a sphere. */
final class SceneText {
    private static final double MAX_EXACT_LONG = 1e15;

    /** A pattern sees a pair as one character, so this matches halves only. */
    private static final Pattern LONE_SURROGATE = Pattern.compile("\\p{Cs}");

    private SceneText() {}

    /**
     * Writes out a scene.
     *
     * @param skybox the panorama's path as it is to stand in the file
     */
    static String of(Scene scene, String skybox) {
        List<String> members = new ArrayList<>();
        members.add(member("version", String.valueOf(Scene.VERSION)));
        members.add(member("name", string(scene.name())));
        members.add(member("description", string(scene.description())));
        members.add(member("camera", camera(scene.camera())));
        members.add(member("light", light(scene.light())));
        members.add(member("plane", plane(scene.plane())));
        members.add(member("skybox", string(skybox)));
        members.add(member("shading", object(member("ambient", number(scene.ambient())))));
        members.add(member("rendering", settings(scene.settings())));
        if (!scene.physics().equals(Physics.DEFAULT)) {
            members.add(member("physics", physics(scene.physics())));
        }
        scene.pour().ifPresent(pour -> members.add(member("pour", pour(pour))));
        members.add(member("spheres", spheres(scene.spheres())));
        return "{\n  " + String.join(",\n  ", members) + "\n}\n";
    }

    private static String camera(Camera camera) {
        return object(
                member("position", vector(camera.position())),
                member("yaw", number(camera.yawDegrees())),
                member("pitch", number(camera.pitchDegrees())),
                member("fieldOfView", number(camera.fieldOfViewDegrees())));
    }

    private static String light(Light light) {
        return object(
                member("position", vector(light.position())),
                member("radius", number(light.radius())),
                member("color", color(light.color())));
    }

    private static String plane(Plane plane) {
        return object(
                member("size", number(plane.size())),
                member("height", number(plane.height())),
                member("colors", array(color(plane.evenColor()), color(plane.oddColor()))),
                member("reflectivity", number(plane.reflectivity())));
    }

    private static String settings(RenderSettings settings) {
        return object(
                member("width", String.valueOf(settings.width())),
                member("height", String.valueOf(settings.height())),
                member("shadowSamples", String.valueOf(settings.shadowSamples())),
                member("bounces", String.valueOf(settings.bounces())),
                member("samplesPerPixel", String.valueOf(settings.samplesPerPixel())),
                member("exposure", number(settings.exposure())),
                member("toneMap", string(ToneMapNames.of(settings.toneMap()))),
                member("srgb", String.valueOf(settings.srgb())));
    }

    private static String physics(Physics physics) {
        return object(
                member("gravity", vector(physics.gravity())),
                member("elasticity", number(physics.elasticity())),
                member("friction", number(physics.friction())),
                member("damping", number(physics.damping())),
                member("walls", String.valueOf(physics.walls())),
                member("solidLight", String.valueOf(physics.solidLight())));
    }

    private static String pour(Pour pour) {
        return object(
                member("count", String.valueOf(pour.count())),
                member("rate", number(pour.rate())),
                member("position", vector(pour.position())),
                member("width", number(pour.width())),
                member("speed", number(pour.speed())),
                member("radius", array(number(pour.minRadius()), number(pour.maxRadius()))),
                member("palette", string(PaletteNames.of(pour.palette()))),
                member("reflectivity", number(pour.reflectivity())),
                member("seed", String.valueOf(pour.seed())));
    }

    private static String spheres(List<Sphere> spheres) {
        return spheres.isEmpty()
                ? "[]"
                : spheres.stream().map(SceneText::sphere).collect(Collectors.joining(",\n    ", "[\n    ", "\n  ]"));
    }

    private static String sphere(Sphere sphere) {
        return object(
                member("position", vector(sphere.position())),
                member("radius", number(sphere.radius())),
                member("color", color(sphere.color())),
                member("reflectivity", number(sphere.reflectivity())));
    }

    private static String vector(Vector3 vector) {
        return array(number(vector.x()), number(vector.y()), number(vector.z()));
    }

    private static String color(Rgb color) {
        return array(number(color.red()), number(color.green()), number(color.blue()));
    }

    private static String object(String... members) {
        return "{" + String.join(", ", members) + "}";
    }

    private static String array(String... items) {
        return Arrays.stream(items).collect(Collectors.joining(", ", "[", "]"));
    }

    private static String member(String name, String value) {
        return string(name) + ": " + value;
    }

    // As short as reads back to the same double; -0.0 keeps its sign.
    private static String number(double number) {
        boolean integral = number == Math.rint(number) && Math.abs(number) < MAX_EXACT_LONG;
        boolean negativeZero = number == 0 && Double.compare(number, 0) < 0;
        return integral && !negativeZero ? String.valueOf((long) number) : String.valueOf(number);
    }

    private static String string(String text) {
        StringBuilder quoted = new StringBuilder("\"");
        JsonStringEncoder.getInstance().quoteAsString(text, quoted);
        return LONE_SURROGATE.matcher(quoted.append('"')).replaceAll(SceneText::escape);
    }

    // UTF-8 has no half of a character; JSON's escapes do.
    private static String escape(MatchResult surrogate) {
        return "\\\\u%04x".formatted((int) surrogate.group().charAt(0));
    }
}
