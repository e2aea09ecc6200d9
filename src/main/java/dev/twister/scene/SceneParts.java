package dev.twister.scene;

import java.util.List;

/** Builds each of a scene's records from its place in the file. */
final class SceneParts {
    private static final List<String> SETTINGS =
            List.of("width", "height", "shadowSamples", "bounces", "samplesPerPixel", "exposure", "toneMap", "srgb");

    private SceneParts() {}

    static Camera camera(Place place) {
        Fields fields = place.fields().check(List.of("position", "yaw", "pitch", "fieldOfView"));
        return new Camera(
                fields.get("position").vector(SceneLimits.POSITION),
                fields.get("yaw").number(SceneLimits.YAW),
                fields.get("pitch").number(SceneLimits.PITCH),
                fields.get("fieldOfView").number(SceneLimits.FIELD_OF_VIEW));
    }

    static Light light(Place place) {
        Fields fields = place.fields().check(List.of("position", "radius", "color"));
        return new Light(
                fields.get("position").vector(SceneLimits.POSITION),
                fields.get("radius").number(SceneLimits.LENGTH),
                color(fields.get("color"), SceneLimits.RADIANCE));
    }

    static Plane plane(Place place) {
        Fields fields = place.fields().check(List.of("size", "height", "colors", "reflectivity"));
        List<Rgb> colors =
                fields.get("colors").items(2, 2, "an array of 2 colors", item -> color(item, SceneLimits.ALBEDO));
        return new Plane(
                fields.get("size").number(SceneLimits.LENGTH),
                fields.get("height").number(SceneLimits.POSITION),
                colors.getFirst(),
                colors.getLast(),
                fields.get("reflectivity").number(SceneLimits.REFLECTIVITY));
    }

    static List<Sphere> spheres(Place place) {
        String allowed = "an array of 0 to " + SceneLimits.MAX_SPHERES + " spheres";
        return place.items(0, SceneLimits.MAX_SPHERES, allowed, SceneParts::sphere);
    }

    static RenderSettings settings(Place place) {
        Fields fields = place.fields().check(List.of(), SETTINGS);
        RenderSettings silent = RenderSettings.DEFAULT;
        return new RenderSettings(
                wholeNumber(fields, "width", SceneLimits.SIDE, silent.width()),
                wholeNumber(fields, "height", SceneLimits.SIDE, silent.height()),
                wholeNumber(fields, "shadowSamples", SceneLimits.SHADOW_SAMPLES, silent.shadowSamples()),
                wholeNumber(fields, "bounces", SceneLimits.BOUNCES, silent.bounces()),
                wholeNumber(fields, "samplesPerPixel", SceneLimits.SAMPLES_PER_PIXEL, silent.samplesPerPixel()),
                fields.find("exposure")
                        .map(exposure -> exposure.number(SceneLimits.EXPOSURE))
                        .orElse(silent.exposure()),
                fields.find("toneMap").map(SceneParts::toneMap).orElse(silent.toneMap()),
                fields.find("srgb").map(Place::flag).orElse(silent.srgb()));
    }

    private static Sphere sphere(Place place) {
        Fields fields = place.fields().check(List.of("position", "radius", "color", "reflectivity"));
        return new Sphere(
                fields.get("position").vector(SceneLimits.POSITION),
                fields.get("radius").number(SceneLimits.LENGTH),
                color(fields.get("color"), SceneLimits.ALBEDO),
                fields.get("reflectivity").number(SceneLimits.REFLECTIVITY));
    }

    private static Rgb color(Place place, Range range) {
        List<Double> components =
                place.items(3, 3, "an array of 3 numbers [red, green, blue]", item -> item.number(range));
        return new Rgb(components.get(0), components.get(1), components.get(2));
    }

    private static int wholeNumber(Fields fields, String name, Range range, int silent) {
        return fields.find(name).map(place -> place.wholeNumber(range)).orElse(silent);
    }

    private static ToneMap toneMap(Place place) {
        return ToneMapNames.toneMap(place.oneOf(ToneMapNames.ALL));
    }
}
