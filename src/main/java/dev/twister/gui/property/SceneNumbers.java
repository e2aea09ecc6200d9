package dev.twister.gui.property;

import dev.twister.gui.edit.Axis;
import dev.twister.gui.property.NumberScale.Spread;
import dev.twister.scene.Scene;
import dev.twister.scene.property.Range;
import dev.twister.scene.property.SceneLimits;
import java.util.List;

/** The numbers of a scene that belong to no light, camera or body. */
public final class SceneNumbers {
    private static final Range FACTOR = new Range(0.05, 20);
    private static final Range SHARE = new Range(0, 1);

    /** A coordinate: the slider goes 5 m to both sides. */
    static final NumberScale PLACE = new NumberScale(SceneLimits.POSITION, new Range(-5, 5), Spread.AROUND, 2, "m");

    public static final NumberProperty<Scene> SHADOW_SAMPLES = new NumberProperty<>(
            "Shadow samples",
            "Light samples per shadow. 1 is a hard shadow; more are softer and slower.",
            "Alt+S",
            new NumberScale(SceneLimits.SHADOW_SAMPLES, new Range(1, 400), Spread.LOGARITHMIC, 0, ""),
            scene -> scene.rendering().shadowSamples(),
            (scene, count) -> scene.withRendering(scene.rendering().withShadowSamples(count.intValue())));

    public static final NumberProperty<Scene> EXPOSURE = new NumberProperty<>(
            "Exposure",
            "Each stop doubles the brightness.",
            "Alt+X",
            new NumberScale(SceneLimits.EXPOSURE, new Range(-6, 6), Spread.LINEAR, 2, "stops"),
            scene -> scene.rendering().exposure(),
            (scene, stops) -> scene.withRendering(scene.rendering()
                    .withTone(
                            stops,
                            scene.rendering().toneMap(),
                            scene.rendering().srgb())));

    public static final List<NumberProperty<Scene>> PICTURE = List.of(
            SHADOW_SAMPLES,
            new NumberProperty<>(
                    "Reflection bounces",
                    "How often a ray is reflected before it ends. 0 is no reflection.",
                    "Alt+B",
                    new NumberScale(SceneLimits.BOUNCES, new Range(0, 6), Spread.LINEAR, 0, ""),
                    scene -> scene.rendering().bounces(),
                    (scene, count) -> scene.withRendering(scene.rendering().withBounces(count.intValue()))),
            new NumberProperty<>(
                    "Samples per pixel",
                    "View rays for each pixel of a moving picture. More make smoother edges, and every frame slower.",
                    "Alt+Shift+J",
                    new NumberScale(SceneLimits.SAMPLES_PER_PIXEL, new Range(1, 64), Spread.LOGARITHMIC, 0, ""),
                    scene -> scene.rendering().samplesPerPixel(),
                    (scene, count) -> scene.withRendering(scene.rendering().withSamplesPerPixel(count.intValue()))),
            EXPOSURE);

    public static final List<NumberProperty<Scene>> SKY = List.of(
            new NumberProperty<>(
                    "Sky rotation",
                    "Turns the panorama about the vertical axis, to the right.",
                    "Alt+D",
                    new NumberScale(SceneLimits.SKY_ROTATION, new Range(-180, 180), Spread.LINEAR, 1, "°"),
                    scene -> scene.sky().rotationDegrees(),
                    (scene, degrees) -> scene.withSky(scene.sky().withRotationDegrees(degrees))),
            new NumberProperty<>(
                    "Sky strength",
                    "Factor on the panorama's radiance.",
                    "Alt+O",
                    new NumberScale(SceneLimits.SKY_STRENGTH, FACTOR, Spread.LOGARITHMIC, 2, ""),
                    scene -> scene.sky().strength(),
                    (scene, strength) -> scene.withSky(scene.sky().withStrength(strength))));

    public static final List<NumberProperty<Scene>> PLANE = List.of(
            new NumberProperty<>(
                    "Plane size",
                    "The side of the square. Walls stand on its border.",
                    "Alt+Shift+P",
                    new NumberScale(SceneLimits.LENGTH, new Range(1, 1000), Spread.LOGARITHMIC, 1, "m"),
                    scene -> scene.ground().size(),
                    (scene, size) -> scene.withGround(scene.ground().withSize(size))),
            new NumberProperty<>(
                    "Plane height",
                    "The plane's y. The camera stays above it.",
                    "Alt+Shift+H",
                    PLACE,
                    scene -> scene.ground().height(),
                    (scene, height) -> scene.withGround(scene.ground().withHeight(height))));

    public static final List<NumberProperty<Scene>> PHYSICS = List.of(
            new NumberProperty<>(
                    "Gravity",
                    "The upward acceleration while bodies move; below 0 they fall, -9.81 is the Earth's.",
                    "Alt+Y",
                    new NumberScale(SceneLimits.GRAVITY, new Range(-30, 30), Spread.LINEAR, 2, "m/s²"),
                    scene -> scene.physics().gravity().y(),
                    (scene, up) -> scene.withPhysics(scene.physics()
                            .withGravity(Axis.Y.with(scene.physics().gravity(), up)))),
            new NumberProperty<>(
                    "Elasticity",
                    "Share of the speed that bodies keep when they bounce.",
                    "Alt+Shift+E",
                    new NumberScale(SceneLimits.ELASTICITY, SHARE, Spread.LINEAR, 2, ""),
                    scene -> scene.physics().elasticity(),
                    (scene, share) -> scene.withPhysics(scene.physics().withElasticity(share))),
            new NumberProperty<>(
                    "Friction",
                    "Coulomb's coefficient between bodies, and between bodies and plane or walls.",
                    "Alt+Shift+F",
                    new NumberScale(SceneLimits.FRICTION, SHARE, Spread.LINEAR, 2, ""),
                    scene -> scene.physics().friction(),
                    (scene, coefficient) -> scene.withPhysics(scene.physics().withFriction(coefficient))));

    private SceneNumbers() {}
}
