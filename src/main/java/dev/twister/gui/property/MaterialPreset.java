package dev.twister.gui.property;

import dev.twister.scene.Material;
import java.util.Arrays;
import java.util.Optional;

/** What a body is often made of, whatever its color and texture. */
public enum MaterialPreset {
    MATTE("Matte", Material.DEFAULT),
    PLASTIC("Plastic", Material.DEFAULT.withReflectivity(16)),
    MIRROR("Mirror", Material.DEFAULT.withReflectivity(128)),
    BRUSHED_METAL("Brushed metal", Material.DEFAULT.withReflectivity(104).withRoughness(0.3)),
    GLASS("Glass", Material.DEFAULT.withTransmission(1)),
    WATER("Water", Material.DEFAULT.withTransmission(1).withIor(1.33)),
    DIAMOND("Diamond", Material.DEFAULT.withTransmission(1).withIor(2.42));

    private final String label;

    @SuppressWarnings("ImmutableEnumChecker") // a record of numbers
    private final Material material;

    MaterialPreset(String label, Material material) {
        this.label = label;
        this.material = material;
    }

    public String label() {
        return label;
    }

    /** The preset that equals a material except for color and texture; empty if none does. */
    public static Optional<MaterialPreset> of(Material material) {
        return Arrays.stream(values())
                .filter(preset -> preset.appliedTo(material).equals(material))
                .findFirst();
    }

    /** That material with all but its color and its texture as here. */
    public Material appliedTo(Material old) {
        Material colored = material.withColor(old.color());
        return old.texture().map(colored::withTexture).orElse(colored);
    }
}
