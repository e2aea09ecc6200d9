package dev.twister.scene;

import java.nio.file.Path;
import java.util.Optional;

/**
 * What a body is made of; the names are glTF 2.0's where it has one.
 *
 * @param color albedo
 * @param reflectivity p in [0, 128]: the Blinn-Phong exponent; p / 128 is the mirror ratio
 * @param roughness r in [0, 1] of the surface that reflects and refracts: 0 is smooth
 * @param transmission t in [0, 1]: how much of the light that is not mirrored passes the surface
 * @param ior index of refraction against what is around the body, in [1, 4]
 * @param texture a picture that the color is multiplied by, already resolved against the scene file's folder
 */
public record Material(
        Rgb color, double reflectivity, double roughness, double transmission, double ior, Optional<Path> texture) {
    /** Matte and white, with the index of glass; has the values of the fields that a file leaves out. */
    public static final Material DEFAULT = new Material(new Rgb(1, 1, 1), 0, 0, 0, 1.5, Optional.empty());

    public Material withColor(Rgb newColor) {
        return new Material(newColor, reflectivity, roughness, transmission, ior, texture);
    }

    public Material withReflectivity(double newReflectivity) {
        return new Material(color, newReflectivity, roughness, transmission, ior, texture);
    }

    public Material withRoughness(double newRoughness) {
        return new Material(color, reflectivity, newRoughness, transmission, ior, texture);
    }

    public Material withTransmission(double newTransmission) {
        return new Material(color, reflectivity, roughness, newTransmission, ior, texture);
    }

    public Material withIor(double newIor) {
        return new Material(color, reflectivity, roughness, transmission, newIor, texture);
    }

    public Material withTexture(Optional<Path> newTexture) {
        return new Material(color, reflectivity, roughness, transmission, ior, newTexture);
    }
}
