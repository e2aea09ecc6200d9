package dev.twister.scene.property;

import static dev.twister.scene.property.Property.choice;
import static dev.twister.scene.property.Property.decimal;
import static dev.twister.scene.property.Property.flag;
import static dev.twister.scene.property.Property.vector;
import static dev.twister.scene.property.Property.whole;
import static dev.twister.scene.property.Slide.SHARE;
import static dev.twister.scene.property.Slide.linear;
import static dev.twister.scene.property.Slide.logarithmic;

import dev.twister.scene.Integrator;
import dev.twister.scene.Physics;
import dev.twister.scene.Rendering;
import dev.twister.scene.Shading;
import dev.twister.scene.Sky;
import dev.twister.scene.ToneMap;
import java.util.List;

/** The properties of a scene's rendering, sky, shading and physics, in the order in which a scene file has them. */
public final class SceneProperties {
    public static final Property<Rendering, Integer> WIDTH = whole(
                    "width", new Range(1, Rendering.MAX_SIDE, "pixels"), Rendering::width, Rendering::withWidth)
            .written()
            .means("of the picture, in pixels");

    public static final Property<Rendering, Integer> HEIGHT = whole(
                    "height", new Range(1, Rendering.MAX_SIDE, "pixels"), Rendering::height, Rendering::withHeight)
            .written()
            .means("of the picture, in pixels");

    public static final Property<Rendering, Integer> SHADOW_SAMPLES = whole(
                    "shadowSamples",
                    new Range(1, Rendering.MAX_SHADOW_SAMPLES),
                    Rendering::shadowSamples,
                    Rendering::withShadowSamples)
            .written()
            .means("points on the light's disc; 1 is a hard shadow")
            .row("Shadow samples", "Light samples per shadow. 1 is a hard shadow; more are softer and slower.", "Alt+S")
            .slide(logarithmic(1, 400, 0, ""))
            .only(Integrator.WHITTED);

    public static final Property<Rendering, Integer> BOUNCES = whole(
                    "bounces", new Range(0, Rendering.MAX_BOUNCES), Rendering::bounces, Rendering::withBounces)
            .written()
            .means("limit of reflections; in path tracing, the number of surfaces after the first one")
            .row("Reflection bounces", "How often a ray is reflected before it ends. 0 is no reflection.", "Alt+B")
            .slide(linear(0, 6, 0, ""));

    public static final Property<Rendering, Integer> SAMPLES_PER_PIXEL = whole(
                    "samplesPerPixel",
                    new Range(1, Rendering.MAX_SAMPLES_PER_PIXEL),
                    Rendering::samplesPerPixel,
                    Rendering::withSamplesPerPixel)
            .written()
            .means("view rays per pixel")
            .row(
                    "Samples per pixel",
                    "View rays for each pixel of a moving picture. More make smoother edges, and every frame slower.",
                    "Alt+Shift+J")
            .slide(logarithmic(1, 64, 0, ""));

    public static final Property<Rendering, Double> EXPOSURE = decimal(
                    "exposure",
                    new Range(-Rendering.MAX_EXPOSURE_STOPS, Rendering.MAX_EXPOSURE_STOPS, "stops"),
                    Rendering::exposure,
                    Rendering::withExposure)
            .written()
            .animated()
            .means("linear color is multiplied by 2^exposure")
            .row("Exposure", "Each stop doubles the brightness.", "Alt+X")
            .slide(linear(-6, 6, 2, "stops"));

    public static final Property<Rendering, ToneMap> TONE_MAP = choice(
                    "toneMap", ToneMap.class, Rendering::toneMap, Rendering::withToneMap)
            .written()
            .means("maps bright colors to the range that a screen can show")
            .row("Tone map", "Maps bright colors to the range that a screen can show.", "Alt+T");

    public static final Property<Rendering, Boolean> SRGB = flag("srgb", Rendering::srgb, Rendering::withSrgb)
            .written()
            .means("whether the sRGB transfer function is applied after tone mapping")
            .row("sRGB curve", "Apply the sRGB transfer function after tone mapping.", "Alt+U");

    public static final Property<Rendering, Integrator> INTEGRATOR = choice(
                    "integrator", Integrator.class, Rendering::integrator, Rendering::withIntegrator)
            .since(3)
            .means("how light is followed: the paper's reflections and shadows, or [path tracing](#path-tracing)")
            .row(
                    "Integrator",
                    "Real time: reflections and one light's shadows. Path tracing: light from everywhere, refined at"
                            + " rest.",
                    "Alt+Shift+V");

    public static final Property<Rendering, Double> CLAMP = decimal(
                    "clamp", new Range(0, 1e6), Rendering::clamp, Rendering::withClamp)
            .since(3)
            .means("in path tracing, limit of the luminance of light that reaches the eye over more than one surface;"
                    + " 0 for none")
            .row(
                    "Clamp",
                    "In path tracing: limit of light that reaches the eye over more than one surface; 0 for none.",
                    "")
            .slide(linear(0, 100, 1, ""))
            .only(Integrator.PATH);

    public static final Property<Rendering, Double> SHUTTER = decimal(
                    "shutter", SceneLimits.SHARE, Rendering::shutter, Rendering::withShutter)
            .since(4)
            .means("[motion blur](films.md#motion-blur): how long the shutter is open before a frame's time, as a"
                    + " fraction of a frame")
            .row(
                    "Shutter",
                    "Motion blur of pictures and films rendered to files: how long the shutter is open, as a fraction"
                            + " of a frame. 0 for none.",
                    "")
            .slide(SHARE);

    public static final List<Property<Rendering, ?>> RENDERING = List.of(
            WIDTH,
            HEIGHT,
            SHADOW_SAMPLES,
            BOUNCES,
            SAMPLES_PER_PIXEL,
            EXPOSURE,
            TONE_MAP,
            SRGB,
            INTEGRATOR,
            CLAMP,
            SHUTTER);

    public static final Property<Sky, Double> SKY_ROTATION = decimal(
                    "rotation", SceneLimits.ANGLE, Sky::rotationDegrees, Sky::withRotationDegrees)
            .animated()
            .means("turn of the panorama to the right")
            .row("Sky rotation", "Turns the panorama about the vertical axis, to the right.", "Alt+D")
            .slide(Slide.ANGLE);

    public static final Property<Sky, Double> SKY_STRENGTH = decimal(
                    "strength", SceneLimits.RADIANCE, Sky::strength, Sky::withStrength)
            .animated()
            .means("factor of the panorama's radiance")
            .row("Sky strength", "Factor on the panorama's radiance.", "Alt+O")
            .slide(logarithmic(0.05, 20, 2, ""));

    public static final List<Property<Sky, ?>> SKY = List.of(SKY_ROTATION, SKY_STRENGTH);

    public static final List<Property<Shading, ?>> SHADING =
            List.of(decimal("ambient", SceneLimits.SHARE, Shading::ambient, (_, ambient) -> new Shading(ambient))
                    .written()
                    .animated()
                    .means("brightness of surfaces in shadow, as a share of their color, without path tracing")
                    .row("Ambient light", "Brightness of surfaces in shadow, as a share of their color.", "Alt+Shift+L")
                    .slide(SHARE)
                    .only(Integrator.WHITTED));

    public static final List<Property<Physics, ?>> PHYSICS = List.of(
            vector("gravity", new Range(-1000, 1000, "m/s^2"), Physics::gravity, Physics::withGravity)
                    .written()
                    .means("acceleration; the Earth's is `[0, -9.81, 0]`")
                    .row(
                            "Gravity",
                            "The acceleration while bodies move. Along y they fall below 0; -9.81 is the Earth's.",
                            " Alt+Y ")
                    .slide(linear(-30, 30, 2, "m/s²")),
            decimal("elasticity", SceneLimits.SHARE, Physics::elasticity, Physics::withElasticity)
                    .written()
                    .means("share of the speed that bodies keep when they bounce")
                    .row("Elasticity", "Share of the speed that bodies keep when they bounce.", "Alt+Shift+E")
                    .slide(SHARE),
            decimal("friction", new Range(0, 10), Physics::friction, Physics::withFriction)
                    .written()
                    .means("Coulomb's coefficient")
                    .row(
                            "Friction",
                            "Coulomb's coefficient between bodies, and between bodies and plane or walls.",
                            "Alt+Shift+F")
                    .slide(SHARE),
            decimal("damping", new Range(0, 100, "1/s"), Physics::damping, Physics::withDamping)
                    .written()
                    .means("rate at which speed is lost")
                    .row("Damping", "Rate at which bodies lose speed, as in thick air; 0 for none.", "")
                    .slide(linear(0, 5, 2, "1/s")),
            flag("walls", Physics::walls, Physics::withWalls)
                    .written()
                    .means("whether four walls without an upper end stand on the plane's border")
                    .row("Walls", "Invisible walls on the border of the plane hold the spheres.", "Alt+Shift+W"),
            flag("solidLight", Physics::solidLight, Physics::withSolidLight)
                    .written()
                    .means("whether spheres bounce off lights; otherwise they pass through")
                    .row("Solid lights", "Spheres bounce off lights. Off: they pass through.", ""));

    private SceneProperties() {}
}
