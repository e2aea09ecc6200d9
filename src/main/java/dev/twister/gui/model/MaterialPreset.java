package dev.twister.gui.model;

import dev.twister.scene.Material;
import java.util.Arrays;
import java.util.Optional;

/** What a body is often made of, whatever its color and texture. */
public enum MaterialPreset {
    MATTE("Matte", 0, 0, 0),
    PLASTIC("Plastic", 16, 0, 0),
    MIRROR("Mirror", 128, 0, 0),
    BRUSHED_METAL("Brushed metal", 104, 0.3, 0),
    GLASS("Glass", 0, 0, 1),
    WATER("Water", 0, 0, 1, 1.33),
    DIAMOND("Diamond", 0, 0, 1, 2.42);

    private final String label;
    private final double reflectivity;
    private final double roughness;
    private final double transmission;
    private final double ior;

    MaterialPreset(String label, double reflectivity, double roughness, double transmission) {
        this(label, reflectivity, roughness, transmission, Material.DEFAULT.ior());
    }

    MaterialPreset(String label, double reflectivity, double roughness, double transmission, double ior) {
        this.label = label;
        this.reflectivity = reflectivity;
        this.roughness = roughness;
        this.transmission = transmission;
        this.ior = ior;
    }

    public String label() {
        return label;
    }

    /** The preset that a material has, whatever its color and texture; empty where it is another one. */
    public static Optional<MaterialPreset> of(Material material) {
        return Arrays.stream(values())
                .filter(preset -> preset.appliedTo(material).equals(material))
                .findFirst();
    }

    /** That material with all but its color and its texture as here. */
    public Material appliedTo(Material material) {
        return material.withReflectivity(reflectivity)
                .withRoughness(roughness)
                .withTransmission(transmission)
                .withIor(ior);
    }
}
