package dev.twister.gui.edit;

import dev.twister.scene.Material;
import dev.twister.scene.Rgb;
import dev.twister.scene.material.Reflectance;
import java.util.Arrays;
import java.util.Optional;
import java.util.function.UnaryOperator;

/** What a body is often made of. A preset changes what it names; texture, maps and the rest stay. */
public enum MaterialPreset {
    MATTE("Matte", old -> dielectric(old, 0)),
    PLASTIC("Plastic", old -> dielectric(old, 0.15)),
    RUBBER("Rubber", old -> dielectric(old, 0.75)),
    CLAY("Clay", old -> dielectric(old, 1).withColor(new Rgb(0.48, 0.24, 0.15))),
    MIRROR("Mirror", old -> dielectric(old, 0).withReflectivity(128)),
    GOLD("Gold", old -> metal(old, new Rgb(1, 0.71, 0.29), 0.12)),
    COPPER("Copper", old -> metal(old, new Rgb(0.96, 0.64, 0.54), 0.15)),
    STEEL("Steel", old -> metal(old, new Rgb(0.56, 0.57, 0.58), 0.22)),
    ALUMINUM("Aluminum", old -> metal(old, new Rgb(0.91, 0.92, 0.92), 0.2)),
    GLASS("Glass", old -> clear(old, 0, 1.5)),
    FROSTED_GLASS("Frosted glass", old -> clear(old, 0.35, 1.5)),
    WATER("Water", old -> clear(old, 0, 1.33)),
    DIAMOND("Diamond", old -> clear(old, 0, 2.42)),
    LAMP(
            "Lamp",
            old -> old.withEmission(
                    old.emission().withColor(new Rgb(1, 0.82, 0.6)).withStrength(8)));

    private final String label;

    @SuppressWarnings("ImmutableEnumChecker") // a function of a record
    private final UnaryOperator<Material> change;

    MaterialPreset(String label, UnaryOperator<Material> change) {
        this.label = label;
        this.change = change;
    }

    public String label() {
        return label;
    }

    /** The first preset that would not change a material; empty if there is none. */
    public static Optional<MaterialPreset> of(Material material) {
        return Arrays.stream(values())
                .filter(preset -> preset.appliedTo(material).equals(material))
                .findFirst();
    }

    /** That material with what the preset names. */
    public Material appliedTo(Material old) {
        return change.apply(old);
    }

    private static Material dielectric(Material old, double roughness) {
        return old.withReflectivity(0)
                .withReflectance(Reflectance.MIXED)
                .withMetallic(0)
                .withTransmission(0)
                .withRoughness(roughness);
    }

    private static Material metal(Material old, Rgb color, double roughness) {
        return dielectric(old, roughness).withMetallic(1).withColor(color);
    }

    private static Material clear(Material old, double roughness, double ior) {
        return dielectric(old, roughness)
                .withColor(new Rgb(1, 1, 1))
                .withTransmission(1)
                .withIor(ior);
    }
}
