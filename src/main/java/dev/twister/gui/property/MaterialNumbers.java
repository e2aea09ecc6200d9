package dev.twister.gui.property;

import dev.twister.gui.edit.BodyMaterials;
import dev.twister.gui.property.NumberScale.Spread;
import dev.twister.kernel.Layout;
import dev.twister.scene.Material;
import dev.twister.scene.Scene;
import dev.twister.scene.property.Range;
import dev.twister.scene.property.SceneLimits;
import java.math.BigDecimal;
import java.math.RoundingMode;
import java.util.List;
import java.util.function.BiFunction;
import java.util.function.ToDoubleFunction;

/** The numbers of a material. */
public final class MaterialNumbers {
    private static final double PERCENT = 100;
    private static final Range PERCENTAGE = new Range(0, PERCENT, "%");

    /** Of the exponent as it is shown. */
    private static final int SHOWN_DECIMALS = 2;

    /** Of the exponent that is computed from a percentage; enough to compute the percentage from it. */
    private static final int KEPT_DECIMALS = 9;

    public static final NumberProperty<Material> REFLECTIVITY = new NumberProperty<>(
            "Reflectivity",
            "Share of the light that is mirrored. The number p beside it is the exponent of the highlight, from 0 "
                    + "(matte) to 128 (mirror).",
            "Alt+8",
            new NumberScale(PERCENTAGE, PERCENTAGE, Spread.LINEAR, 1, "%"),
            material -> material.reflectivity() / Layout.MAX_REFLECTIVITY * PERCENT,
            (material, percent) ->
                    material.withReflectivity(rounded(percent / PERCENT * Layout.MAX_REFLECTIVITY, KEPT_DECIMALS)
                            .doubleValue()));

    /** The rows of the panel, in their order. */
    public static final List<NumberProperty<Material>> ALL = List.of(
            REFLECTIVITY,
            fraction(
                    "Roughness",
                    "How much reflections and refractions are blurred: 0 is smooth, 1 is rough. The picture at rest "
                            + "gathers samples until the noise is gone.",
                    "Alt+Shift+R",
                    SceneLimits.ROUGHNESS,
                    Material::roughness,
                    Material::withRoughness),
            fraction(
                    "Transmission",
                    "Share of the light that is not mirrored and passes through the surface: 0 is opaque, 1 is clear.",
                    "Alt+Shift+T",
                    SceneLimits.TRANSMISSION,
                    Material::transmission,
                    Material::withTransmission),
            new NumberProperty<>(
                    "Index of refraction",
                    "How much transmitted light is bent: water 1.33, glass 1.5, diamond 2.42.",
                    "Alt+Shift+I",
                    new NumberScale(SceneLimits.IOR, new Range(1, 2.5), Spread.LINEAR, 2, ""),
                    Material::ior,
                    Material::withIor));

    private MaterialNumbers() {}

    /** A number of one body's material. */
    public static NumberProperty<Scene> of(int body, NumberProperty<Material> number) {
        return number.in(
                scene -> BodyMaterials.of(scene, body), (scene, edit) -> BodyMaterials.edited(scene, body, edit));
    }

    /** The unit of the reflectivity, with the exponent that scene files have: {@code % (p 24)}. */
    public static String percentUnit(Material material) {
        BigDecimal shown = rounded(material.reflectivity(), SHOWN_DECIMALS).stripTrailingZeros();
        return "% (p " + shown.toPlainString() + ")";
    }

    private static BigDecimal rounded(double reflectivity, int decimals) {
        return BigDecimal.valueOf(reflectivity).setScale(decimals, RoundingMode.HALF_UP);
    }

    private static NumberProperty<Material> fraction(
            String label,
            String hint,
            String key,
            Range range,
            ToDoubleFunction<Material> getter,
            BiFunction<Material, Double, Material> wither) {
        return new NumberProperty<>(
                label, hint, key, new NumberScale(range, range, Spread.LINEAR, 2, ""), getter, wither);
    }
}
