package dev.twister.scene.property;

import static dev.twister.scene.property.Property.choice;
import static dev.twister.scene.property.Property.color;
import static dev.twister.scene.property.Property.decimal;
import static dev.twister.scene.property.Property.vector;
import static dev.twister.scene.property.Slide.linear;
import static dev.twister.scene.property.Slide.logarithmic;

import dev.twister.scene.Integrator;
import dev.twister.scene.Light;
import dev.twister.scene.Rgb;
import dev.twister.scene.Vector3;
import dev.twister.scene.light.LightShape;
import dev.twister.scene.property.PropertyType.Decimal;
import dev.twister.scene.property.PropertyType.Given;
import dev.twister.scene.property.PropertyType.LayerName;
import java.util.List;
import java.util.Optional;

/** The properties of a light, in the order in which a scene file has them. */
public final class LightProperties {
    public static final Property<Light, Double> RADIUS = decimal(
                    "radius", SceneLimits.LENGTH, Light::radius, Light::withRadius)
            .written()
            .animated()
            .means("a larger light makes softer shadows")
            .row("Light size", "The light's radius. A larger light makes softer shadows.", "Alt+L")
            .slide(logarithmic(0.05, 10, 2, "m"));

    public static final Property<Light, Rgb> COLOR = color(
                    "color", SceneLimits.RADIANCE, Light::color, Light::withColor)
            .written()
            .animated()
            .means("linear color of the sphere and of its highlights")
            .row("Light color", "The light's color. Set brightness with Light brightness.", "Alt+C");

    public static final Property<Light, Optional<Double>> STRENGTH = Property.<Light, Optional<Double>>of(
                    "strength",
                    new Given<>(new Decimal(new Range(0, 1e9, "m^2"))),
                    Light::strength,
                    Light::withStrength)
            .since(3)
            .animated()
            .means("brightness in [path tracing](#path-tracing); by the plane's distance where it is not given")
            .row(
                    "Light strength",
                    "In path tracing: the irradiance over pi, at 1 m, of a surface that faces the light, is its color "
                            + "times this. Default: the ground is about as bright as without path tracing.",
                    "Alt+Shift+Q")
            .slide(logarithmic(0.1, 1000, 2, "m²"))
            .only(Integrator.PATH);

    public static final Property<Light, Double> SHARE = decimal(
                    "share", new Range(0, 1000), Light::share, Light::withShare)
            .since(3)
            .animated()
            .means("factor k of what it adds to the brightness of matte surfaces, without path tracing")
            .row(
                    "Light share",
                    "Without path tracing: factor of what the light adds to the brightness of matte surfaces.",
                    "Alt+0")
            .slide(linear(0, 2, 2, ""))
            .only(Integrator.WHITTED);

    public static final Property<Light, LightShape.Kind> TYPE = choice(
                    "type", LightShape.Kind.class, LightShape::kind, LightShape::withKind)
            .since(4)
            .means("what gives the light; a sphere where it is not given")
            .within(Light::shape, Light::withShape);

    public static final Property<Light, Vector3> DIRECTION = vector(
                    "direction", new Range(-1e6, 1e6), LightShape::direction, LightShape::withDirection)
            .since(4)
            .animated()
            .means("in which it shines, of any length above 0")
            .row("Light direction", "The direction in which the light shines.", "")
            .slide(linear(-1, 1, 2, ""))
            .within(Light::shape, Light::withShape);

    private static final Property<Light, Double> ANGULAR_DIAMETER = decimal(
                    "angularDiameter",
                    new Range(0, 90, "degrees"),
                    LightShape::angularDiameterDegrees,
                    LightShape::withAngularDiameterDegrees)
            .since(4)
            .animated()
            .means("of a sun's disc; 0 makes sharp shadows, the Earth's sun has 0.53")
            .row("Sun size", "The angle that the sun's disc fills. A larger sun makes softer shadows.", "")
            .slide(linear(0, 10, 2, "°"))
            .within(Light::shape, Light::withShape);

    private static final Property<Light, Double> CONE_ANGLE = decimal(
                    "coneAngle",
                    new Range(0.1, 180, "degrees"),
                    LightShape::coneAngleDegrees,
                    LightShape::withConeAngleDegrees)
            .since(4)
            .animated()
            .means("between opposite sides of a spot's cone; twice glTF's `outerConeAngle`")
            .row("Spot angle", "The angle between opposite sides of the spot's cone.", "")
            .slide(linear(1, 180, 1, "°"))
            .within(Light::shape, Light::withShape);

    private static final Property<Light, Double> CONE_BLEND = decimal(
                    "coneBlend", SceneLimits.SHARE, LightShape::coneBlend, LightShape::withConeBlend)
            .since(4)
            .animated()
            .means("part of the cone over which a spot fades out; 1 - glTF's `innerConeAngle` / `outerConeAngle`")
            .row("Spot blend", "How much of the cone, from its border inward, the light takes to fade out.", "")
            .slide(linear(0, 1, 2, ""))
            .within(Light::shape, Light::withShape);

    public static final List<Property<Light, ?>> ALL = List.of(
            TYPE,
            vector("position", SceneLimits.POSITION, Light::position, Light::withPosition)
                    .written()
                    .animated()
                    .means("the center")
                    .row("Light", "The light's position.", "Alt+1 Alt+2 Alt+3")
                    .slide(Slide.PLACE),
            RADIUS,
            DIRECTION,
            ANGULAR_DIAMETER,
            CONE_ANGLE,
            CONE_BLEND,
            COLOR,
            STRENGTH,
            SHARE,
            Property.<Light, String>of("lightGroup", new LayerName(), Light::group, Light::withGroup)
                    .since(3)
                    .means("name of the [layer](denoising.md#light-by-light) of its light")
                    .row("Light layer", "Name of the layer of its light, for --light-layers.", ""));

    private LightProperties() {}

    /** Whether a kind of light has the property. */
    public static boolean has(LightShape.Kind kind, String property) {
        return switch (property) {
            case "position", "radius" -> kind != LightShape.Kind.SUN;
            case "direction" -> kind != LightShape.Kind.SPHERE;
            case "angularDiameter" -> kind == LightShape.Kind.SUN;
            case "coneAngle", "coneBlend" -> kind == LightShape.Kind.SPOT;
            default -> true;
        };
    }
}
