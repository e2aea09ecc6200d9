package dev.twister.gui.model;

import dev.twister.gui.model.NumberSetting.Scale;
import dev.twister.scene.Light;
import dev.twister.scene.Lights;
import dev.twister.scene.Range;
import dev.twister.scene.Scene;
import dev.twister.scene.SceneLimits;
import dev.twister.scene.Vector3;
import java.util.function.BiFunction;
import java.util.function.ToDoubleFunction;
import java.util.function.UnaryOperator;

/** The numbers of a scene, apart from its bodies', that the panel changes. */
public final class SceneNumbers {
    /** From where a body is, in meters. */
    private static final Range NEARBY = new Range(-5, 5);

    private static final Range SMALL_LENGTHS = new Range(0.05, 10);

    public static final NumberSetting SHADOW_SAMPLES = new NumberSetting(
            "Shadow samples",
            "Light samples per shadow. 1 is a hard shadow; more are softer and slower.",
            SceneLimits.SHADOW_SAMPLES,
            new Range(1, 400),
            Scale.LOGARITHMIC,
            0,
            "",
            scene -> scene.rendering().shadowSamples(),
            (scene, count) -> scene.withRendering(scene.rendering().withShadows(count.intValue())));

    public static final NumberSetting BOUNCES = new NumberSetting(
            "Reflection bounces",
            "How often a ray is reflected before it ends. 0 is no reflection.",
            SceneLimits.BOUNCES,
            new Range(0, 6),
            Scale.LINEAR,
            0,
            "",
            scene -> scene.rendering().bounces(),
            (scene, count) -> scene.withRendering(scene.rendering().withBounces(count.intValue())));

    public static final NumberSetting SAMPLES_PER_PIXEL = new NumberSetting(
            "Samples per pixel",
            "View rays for each pixel of a moving picture. More make smoother edges, and every frame slower.",
            SceneLimits.SAMPLES_PER_PIXEL,
            new Range(1, 64),
            Scale.LOGARITHMIC,
            0,
            "",
            scene -> scene.rendering().samplesPerPixel(),
            (scene, count) -> scene.withRendering(scene.rendering().withSamplesPerPixel(count.intValue())));

    public static final NumberSetting EXPOSURE = new NumberSetting(
            "Exposure",
            "Each stop doubles the brightness.",
            SceneLimits.EXPOSURE,
            new Range(-6, 6),
            Scale.LINEAR,
            2,
            "stops",
            scene -> scene.rendering().exposure(),
            (scene, stops) -> scene.withRendering(scene.rendering()
                    .withTone(
                            stops,
                            scene.rendering().toneMap(),
                            scene.rendering().srgb())));

    public static final NumberSetting FIELD_OF_VIEW = new NumberSetting(
            "Field of view",
            "Field of view over the shorter side of the picture. Small is a telephoto lens, large a wide angle.",
            SceneLimits.FIELD_OF_VIEW,
            new Range(10, 120),
            Scale.LINEAR,
            1,
            "°",
            scene -> scene.camera().fieldOfViewDegrees(),
            (scene, degrees) -> scene.withCamera(scene.camera().withFieldOfView(degrees)));

    public static final NumberSetting APERTURE = new NumberSetting(
            "Aperture",
            "The lens's radius. 0 is sharp everywhere; larger values blur more of what is not in focus.",
            SceneLimits.APERTURE,
            new Range(0, 0.5),
            Scale.LINEAR,
            3,
            "m",
            scene -> scene.camera().aperture(),
            (scene, radius) -> scene.withCamera(scene.camera().withAperture(radius)));

    public static final NumberSetting FOCUS_DISTANCE = new NumberSetting(
            "Focus distance",
            "Distance to the plane in focus, straight ahead. Ctrl+Shift+click in the picture sets it.",
            SceneLimits.FOCUS_DISTANCE,
            new Range(0.1, 100),
            Scale.LOGARITHMIC,
            2,
            "m",
            scene -> scene.camera().focusDistance(),
            (scene, meters) -> scene.withCamera(scene.camera().withFocusDistance(meters)));

    public static final NumberSetting LIGHT_X = lightPlace(
            "Light x",
            "The light's place from left to right.",
            Vector3::x,
            (place, x) -> new Vector3(x, place.y(), place.z()));

    public static final NumberSetting LIGHT_Y = lightPlace(
            "Light y", "The light's height.", Vector3::y, (place, y) -> new Vector3(place.x(), y, place.z()));

    public static final NumberSetting LIGHT_Z = lightPlace(
            "Light z",
            "The light's place from near to far.",
            Vector3::z,
            (place, z) -> new Vector3(place.x(), place.y(), z));

    public static final NumberSetting LIGHT_RADIUS = new NumberSetting(
            "Light size",
            "The light's radius. A larger light makes softer shadows.",
            SceneLimits.LENGTH,
            SMALL_LENGTHS,
            Scale.LOGARITHMIC,
            2,
            "m",
            scene -> scene.lights().first().radius(),
            (scene, radius) -> light(scene, light -> light.withRadius(radius)));

    public static final NumberSetting LIGHT_STRENGTH = new NumberSetting(
            "Light strength",
            "The brightest channel of the light's color; 1 is white paper lit from straight above.",
            SceneLimits.RADIANCE,
            new Range(0.05, 20),
            Scale.LOGARITHMIC,
            2,
            "",
            scene -> Radiance.of(scene.lights().first().color()).strength(),
            (scene, strength) -> light(
                    scene,
                    light -> light.withColor(
                            new Radiance(Radiance.of(light.color()).hue(), strength).color())));

    public static final NumberSetting SKY_ROTATION = new NumberSetting(
            "Sky rotation",
            "Turns the panorama about the vertical axis, to the right.",
            SceneLimits.SKY_ROTATION,
            new Range(-180, 180),
            Scale.LINEAR,
            1,
            "°",
            scene -> scene.sky().rotationDegrees(),
            (scene, degrees) -> scene.withSky(scene.sky().withRotation(degrees)));

    public static final NumberSetting SKY_STRENGTH = new NumberSetting(
            "Sky strength",
            "Factor on the panorama's radiance.",
            SceneLimits.SKY_STRENGTH,
            new Range(0.05, 20),
            Scale.LOGARITHMIC,
            2,
            "",
            scene -> scene.sky().strength(),
            (scene, strength) -> scene.withSky(scene.sky().withStrength(strength)));

    public static final NumberSetting GRAVITY = new NumberSetting(
            "Gravity",
            "The upward acceleration while bodies move; below 0 they fall, -9.81 is the Earth's.",
            SceneLimits.GRAVITY,
            new Range(-30, 30),
            Scale.LINEAR,
            2,
            "m/s²",
            scene -> scene.physics().gravity().y(),
            (scene, up) -> scene.withPhysics(scene.physics()
                    .withGravity(new Vector3(
                            scene.physics().gravity().x(),
                            up,
                            scene.physics().gravity().z()))));

    private SceneNumbers() {}

    static NumberSetting place(
            String label, String hint, ToDoubleFunction<Scene> reader, BiFunction<Scene, Double, Scene> writer) {
        return new NumberSetting(label, hint, SceneLimits.POSITION, NEARBY, Scale.AROUND, 2, "m", reader, writer);
    }

    private static NumberSetting lightPlace(
            String label, String hint, ToDoubleFunction<Vector3> reader, BiFunction<Vector3, Double, Vector3> writer) {
        return place(
                label,
                hint,
                scene -> reader.applyAsDouble(scene.lights().first().position()),
                (scene, number) -> light(scene, light -> light.withPosition(writer.apply(light.position(), number))));
    }

    private static Scene light(Scene scene, UnaryOperator<Light> edit) {
        return scene.withLights(Lights.of(edit.apply(scene.lights().first())));
    }
}
