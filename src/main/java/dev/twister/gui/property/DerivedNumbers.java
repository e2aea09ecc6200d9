package dev.twister.gui.property;

import dev.twister.gui.edit.Axis;
import dev.twister.kernel.Layout;
import dev.twister.scene.Camera;
import dev.twister.scene.Light;
import dev.twister.scene.Material;
import dev.twister.scene.Mesh;
import dev.twister.scene.Rgb;
import dev.twister.scene.Scene;
import dev.twister.scene.Shape;
import dev.twister.scene.property.CameraProperties;
import dev.twister.scene.property.LightProperties;
import dev.twister.scene.property.MaterialProperties;
import dev.twister.scene.property.Range;
import dev.twister.scene.property.Row;
import dev.twister.scene.property.SceneLimits;
import dev.twister.scene.property.Slide;
import dev.twister.world.LightStrength;
import java.math.BigDecimal;
import java.math.RoundingMode;
import java.util.function.IntSupplier;
import java.util.function.UnaryOperator;
import java.util.stream.Stream;

/** Numbers that the window shows in another form than a scene file has. */
public final class DerivedNumbers {
    /** Half the height of a frame of 35 mm film. */
    private static final double HALF_FRAME_MILLIMETERS = 12;

    /** Of the angle, so that the same length leads to the same angle. */
    private static final int DECIMALS = 12;

    private static final Range PERSPECTIVE = CameraProperties.fieldOfView(Camera.Projection.PERSPECTIVE);

    static final NumberProperty<Camera> FOCAL_LENGTH = new NumberProperty<>(
            "Focal length",
            "The field of view as the focal length of a lens on 35 mm film, whose frame is 24 mm high.",
            "",
            new NumberScale(
                    new Range(focalLength(PERSPECTIVE.max()), focalLength(PERSPECTIVE.min()), "mm"),
                    Slide.logarithmic(8, 200, 1, "mm")),
            camera -> focalLength(PERSPECTIVE.clamp(camera.fieldOfViewDegrees())),
            (camera, millimeters) -> camera.withFieldOfViewDegrees(fieldOfView(millimeters)));

    public static final NumberProperty<Light> BRIGHTNESS = new NumberProperty<>(
            "Light brightness",
            "The brightest channel of the light's color; 1 is white paper lit from straight above.",
            "Alt+Q",
            new NumberScale(SceneLimits.RADIANCE, Slide.logarithmic(0.05, 20, 2, "")),
            light -> Radiance.of(light.color()).strength(),
            (light, strength) ->
                    light.withColor(new Radiance(Radiance.of(light.color()).hue(), strength).color()));

    private static final double PERCENT = 100;

    /** Of the exponent as it is shown. */
    private static final int SHOWN_DECIMALS = 2;

    /** Of the exponent that is computed from a percentage; enough to compute the percentage from it. */
    private static final int KEPT_DECIMALS = 9;

    public static final NumberProperty<Material> REFLECTIVITY = new NumberProperty<>(
            MaterialProperties.REFLECTIVITY.row().label(),
            MaterialProperties.REFLECTIVITY.row().hint(),
            MaterialProperties.REFLECTIVITY.row().keys(),
            new NumberScale(new Range(0, PERCENT, "%"), Slide.linear(0, PERCENT, 1, "%")),
            material -> material.reflectivity() / Layout.MAX_REFLECTIVITY * PERCENT,
            (material, percent) ->
                    material.withReflectivity(rounded(percent / PERCENT * Layout.MAX_REFLECTIVITY, KEPT_DECIMALS)
                            .doubleValue()));

    private static final NumberScale SIDE = new NumberScale(SceneLimits.LENGTH, Slide.logarithmic(0.05, 20, 2, "m"));

    /** Of the width of a torus: its height must be below half of it. */
    private static final double MOST_OF_A_TORUS = 0.499;

    private DerivedNumbers() {}

    /** The unit of the reflectivity, with the exponent that scene files have: {@code % (p 24)}. */
    public static String percentUnit(Material material) {
        BigDecimal shown = rounded(material.reflectivity(), SHOWN_DECIMALS).stripTrailingZeros();
        return "% (p " + shown.toPlainString() + ")";
    }

    private static BigDecimal rounded(double reflectivity, int decimals) {
        return BigDecimal.valueOf(reflectivity).setScale(decimals, RoundingMode.HALF_UP);
    }

    private static double focalLength(double degrees) {
        return HALF_FRAME_MILLIMETERS / Math.tan(Math.toRadians(degrees / 2));
    }

    private static double fieldOfView(double millimeters) {
        double degrees = 2 * Math.toDegrees(Math.atan(HALF_FRAME_MILLIMETERS / millimeters));
        return CameraProperties.FIELD_OF_VIEW
                .range()
                .clamp(BigDecimal.valueOf(degrees)
                        .setScale(DECIMALS, RoundingMode.HALF_UP)
                        .doubleValue());
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

    /** A light's strength, the usual one where it has none. */
    static NumberProperty<Scene> strength(IntSupplier index) {
        Row row = LightProperties.STRENGTH.row();
        return new NumberProperty<>(
                row.label(),
                row.hint(),
                row.keys(),
                new NumberScale(LightProperties.STRENGTH.range(), row.slide()),
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

    /** The sides of a mesh's shape; none where it has none. */
    static Stream<NumberProperty<Mesh>> sides(Mesh mesh) {
        return mesh.geometry() instanceof Shape shape
                ? Stream.of(
                                side("width", Axis.X, "Alt+Shift+8"),
                                side("height", Axis.Y, "Alt+Shift+9"),
                                side("depth", Axis.Z, "Alt+Shift+0"))
                        .limit(shape.kind() == Shape.Kind.QUAD ? 2 : 3)
                : Stream.empty();
    }

    private static NumberProperty<Mesh> side(String name, Axis axis, String key) {
        return new NumberProperty<>(
                "Shape " + name,
                "The " + name + " of the box that the shape fills before it is scaled and rotated.",
                key,
                SIDE,
                mesh -> axis.of(shape(mesh).size()),
                (mesh, meters) -> mesh.withGeometry(new Shape(
                        shape(mesh).kind(), axis.with(shape(mesh).size(), possible(shape(mesh), axis, meters)))));
    }

    private static Shape shape(Mesh mesh) {
        if (mesh.geometry() instanceof Shape shape) {
            return shape;
        }
        throw new IllegalArgumentException("no shape: " + mesh.geometry().name());
    }

    /** The hole of a torus stays open. */
    private static double possible(Shape shape, Axis axis, double meters) {
        if (shape.kind() != Shape.Kind.TORUS || axis == Axis.Z) {
            return meters;
        }
        return axis == Axis.X
                ? Math.max(meters, shape.size().y() / MOST_OF_A_TORUS)
                : Math.min(meters, shape.size().x() * MOST_OF_A_TORUS);
    }

    /**
     * Radiance as the user sets it: a hue that a color chooser can show, and a strength.
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
