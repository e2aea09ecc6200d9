package dev.twister.gui.model;

import dev.twister.gui.model.NumberSetting.Scale;
import dev.twister.kernel.Layout;
import dev.twister.scene.Material;
import dev.twister.scene.Range;
import dev.twister.scene.Scene;
import dev.twister.scene.SceneLimits;
import java.math.BigDecimal;
import java.math.RoundingMode;
import java.util.List;
import java.util.function.BiFunction;
import java.util.function.Function;
import java.util.function.UnaryOperator;

/**
 * The numbers of a material.
 *
 * @param reader the material of a scene
 * @param editor the scene with the material changed
 */
public record MaterialNumbers(
        Function<Scene, Material> reader, BiFunction<Scene, UnaryOperator<Material>, Scene> editor) {
    private static final double PERCENT = 100;
    private static final Range PERCENTAGE = new Range(0, PERCENT, "%");

    /** Of the exponent as it is shown. */
    private static final int SHOWN_DECIMALS = 2;

    /** Of the exponent that is made of a percentage, which leads back to it. */
    private static final int KEPT_DECIMALS = 9;

    /** Those of one body alone. */
    public static MaterialNumbers of(int body) {
        return new MaterialNumbers(
                scene -> BodyMaterials.of(scene, body), (scene, edit) -> BodyMaterials.edited(scene, body, edit));
    }

    public List<NumberSetting> all() {
        return List.of(reflectivity(), roughness(), transmission(), ior());
    }

    public NumberSetting reflectivity() {
        return new NumberSetting(
                "Reflectivity",
                "Share of the light that is mirrored. The number p beside it is the exponent of the highlight, from 0 "
                        + "(matte) to 128 (mirror).",
                PERCENTAGE,
                PERCENTAGE,
                Scale.LINEAR,
                1,
                "%",
                scene -> reader.apply(scene).reflectivity() / Layout.MAX_REFLECTIVITY * PERCENT,
                (scene, percent) -> editor.apply(scene, material -> material.withReflectivity(reflectivity(percent))));
    }

    private static double reflectivity(double percent) {
        return rounded(percent / PERCENT * Layout.MAX_REFLECTIVITY, KEPT_DECIMALS)
                .doubleValue();
    }

    private static BigDecimal rounded(double reflectivity, int decimals) {
        return BigDecimal.valueOf(reflectivity).setScale(decimals, RoundingMode.HALF_UP);
    }

    /** The unit of the reflectivity, with the number that scene files have: {@code % (p 24)}. */
    public static String percentUnit(Material material) {
        BigDecimal shown = rounded(material.reflectivity(), SHOWN_DECIMALS).stripTrailingZeros();
        return "% (p " + shown.toPlainString() + ")";
    }

    public NumberSetting roughness() {
        return fraction(
                "Roughness",
                "How much reflections and refractions are blurred: 0 is smooth, 1 is rough. The picture at rest gathers "
                        + "samples until the noise is gone.",
                SceneLimits.ROUGHNESS,
                Material::roughness,
                Material::withRoughness);
    }

    public NumberSetting transmission() {
        return fraction(
                "Transmission",
                "Share of the light that is not mirrored and passes through the surface: 0 is opaque, 1 is clear.",
                SceneLimits.TRANSMISSION,
                Material::transmission,
                Material::withTransmission);
    }

    public NumberSetting ior() {
        return new NumberSetting(
                "Index of refraction",
                "How much transmitted light is bent: water 1.33, glass 1.5, diamond 2.42.",
                SceneLimits.IOR,
                new Range(1, 2.5),
                Scale.LINEAR,
                2,
                "",
                scene -> reader.apply(scene).ior(),
                (scene, ior) -> editor.apply(scene, material -> material.withIor(ior)));
    }

    private NumberSetting fraction(
            String label,
            String hint,
            Range range,
            Function<Material, Double> get,
            BiFunction<Material, Double, Material> with) {
        return new NumberSetting(
                label,
                hint,
                range,
                range,
                Scale.LINEAR,
                2,
                "",
                scene -> get.apply(reader.apply(scene)),
                (scene, number) -> editor.apply(scene, material -> with.apply(material, number)));
    }
}
