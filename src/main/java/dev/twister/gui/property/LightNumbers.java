package dev.twister.gui.property;

import dev.twister.gui.edit.Axis;
import dev.twister.gui.property.NumberScale.Spread;
import dev.twister.scene.Light;
import dev.twister.scene.Rgb;
import dev.twister.scene.Scene;
import dev.twister.scene.Shading;
import dev.twister.scene.property.Range;
import dev.twister.scene.property.SceneLimits;
import dev.twister.world.LightStrength;
import java.util.List;
import java.util.function.IntSupplier;
import java.util.function.UnaryOperator;
import java.util.stream.Stream;

/** The numbers of a light, and ambient light. */
public final class LightNumbers {
    public static final NumberProperty<Light> RADIUS = new NumberProperty<>(
            "Light size",
            "The light's radius. A larger light makes softer shadows.",
            "Alt+L",
            new NumberScale(SceneLimits.LENGTH, new Range(0.05, 10), Spread.LOGARITHMIC, 2, "m"),
            Light::radius,
            Light::withRadius);

    public static final NumberProperty<Light> BRIGHTNESS = new NumberProperty<>(
            "Light brightness",
            "The brightest channel of the light's color; 1 is white paper lit from straight above.",
            "Alt+Q",
            new NumberScale(SceneLimits.RADIANCE, new Range(0.05, 20), Spread.LOGARITHMIC, 2, ""),
            light -> Radiance.of(light.color()).strength(),
            (light, strength) ->
                    light.withColor(new Radiance(Radiance.of(light.color()).hue(), strength).color()));

    private static final NumberProperty<Light> SHARE = new NumberProperty<>(
            "Light share",
            "Without path tracing: factor of what the light adds to the brightness of matte surfaces.",
            "Alt+0",
            new NumberScale(SceneLimits.LIGHT_SHARE, new Range(0, 2), Spread.LINEAR, 2, ""),
            Light::share,
            Light::withShare);

    private static final NumberProperty<Scene> AMBIENT = new NumberProperty<>(
            "Ambient light",
            "Brightness of surfaces in shadow, as a share of their color.",
            "Alt+Shift+L",
            new NumberScale(SceneLimits.AMBIENT, new Range(0, 1), Spread.LINEAR, 2, ""),
            scene -> scene.shading().ambient(),
            (scene, ambient) -> scene.withShading(new Shading(ambient)));

    /** The rows of the panel for the first light, in their order. */
    public static final List<NumberProperty<Scene>> ALL = of(() -> 0);

    private LightNumbers() {}

    /**
     * The rows of the panel, in their order.
     *
     * @param index place of the shown light in the scene's list
     */
    public static List<NumberProperty<Scene>> of(IntSupplier index) {
        return Stream.concat(
                        Stream.of(
                                        place(Axis.X, "The light's position from left to right.", "Alt+1"),
                                        place(Axis.Y, "The light's height.", "Alt+2"),
                                        place(Axis.Z, "The light's position from near to far.", "Alt+3"),
                                        RADIUS,
                                        BRIGHTNESS)
                                .map(number -> ofScene(number, index)),
                        Stream.of(strength(index), ofScene(SHARE, index), AMBIENT))
                .toList();
    }

    /** A number of the first light. */
    public static NumberProperty<Scene> ofScene(NumberProperty<Light> number) {
        return ofScene(number, () -> 0);
    }

    private static NumberProperty<Scene> ofScene(NumberProperty<Light> number, IntSupplier index) {
        return number.in(scene -> light(scene, index), (scene, edit) -> edited(scene, index, edit));
    }

    /** The light at a place of the scene's list; the first where there is none. */
    public static Light light(Scene scene, IntSupplier index) {
        return scene.lights().get(present(scene, index));
    }

    /** The scene with that light edited. */
    public static Scene edited(Scene scene, IntSupplier index, UnaryOperator<Light> edit) {
        return scene.withLights(scene.lights().with(present(scene, index), edit.apply(light(scene, index))));
    }

    private static int present(Scene scene, IntSupplier index) {
        return index.getAsInt() < scene.lights().count() ? index.getAsInt() : 0;
    }

    private static NumberProperty<Scene> strength(IntSupplier index) {
        return new NumberProperty<>(
                "Light strength",
                "In path tracing: the irradiance over pi, at 1 m, of a surface that faces the light, is its color times "
                        + "this. Default: the ground is about as bright as without path tracing.",
                "Alt+Shift+Q",
                new NumberScale(SceneLimits.LIGHT_STRENGTH, new Range(0.1, 1000), Spread.LOGARITHMIC, 2, "m²"),
                scene -> light(scene, index).strength().orElseGet(() -> usualStrength(scene, index)),
                (scene, strength) -> edited(
                        scene,
                        index,
                        light -> strength == usualStrength(scene, index)
                                ? light.withoutStrength()
                                : light.withStrength(strength)));
    }

    private static double usualStrength(Scene scene, IntSupplier index) {
        return LightStrength.usual(light(scene, index), scene.ground());
    }

    private static NumberProperty<Light> place(Axis axis, String hint, String key) {
        return new NumberProperty<>(
                "Light " + axis.label(),
                hint,
                key,
                SceneNumbers.PLACE,
                light -> axis.of(light.position()),
                (light, number) -> light.withPosition(axis.with(light.position(), number)));
    }

    /**
     * A light's color as the user sets it: a hue that a color chooser can show, and a strength.
     *
     * @param hue its largest channel is 1
     * @param strength 0 or more
     */
    public record Radiance(Rgb hue, double strength) {
        private static final Rgb WHITE = new Rgb(1, 1, 1);

        /** A light that is out counts as white. */
        public static Radiance of(Rgb color) {
            double strength = Math.max(color.red(), Math.max(color.green(), color.blue()));
            if (strength == 0) {
                return new Radiance(WHITE, 0);
            }
            return new Radiance(
                    new Rgb(color.red() / strength, color.green() / strength, color.blue() / strength), strength);
        }

        /** The same strength in the hue of another color, however dark that is; black is white. */
        public Radiance withHueOf(Rgb color) {
            return new Radiance(of(color).hue(), strength);
        }

        public Rgb color() {
            return new Rgb(hue.red() * strength, hue.green() * strength, hue.blue() * strength);
        }
    }
}
