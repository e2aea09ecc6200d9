package dev.twister.mesh.obj;

import dev.twister.mesh.input.OptionalValue;
import dev.twister.mesh.input.Reflectivity;
import dev.twister.scene.Material;
import dev.twister.scene.Rgb;
import dev.twister.scene.material.Alpha;
import dev.twister.scene.material.Emission;
import dev.twister.scene.material.Finish;
import dev.twister.scene.material.ImageMap;
import dev.twister.scene.material.Maps;
import dev.twister.scene.material.Sampler;
import java.util.Optional;

/** The fields of a material in an MTL file, and their conversion to Twister's material. */
final class MtlMaterial {
    private static final double MAX_EXPONENT = 1000;

    /** The format has none; that of Blender, which writes such files. */
    private static final double SHEEN_ROUGHNESS = 0.5;

    Rgb diffuse = Material.DEFAULT.color();
    Optional<Rgb> specular = Optional.empty();
    Optional<Rgb> filter = Optional.empty();
    Optional<Double> opacity = Optional.empty();
    Optional<Double> transparency = Optional.empty();
    Optional<Double> ior = Optional.empty();
    Optional<ImageMap> texture = Optional.empty();
    Maps maps = Maps.NONE;
    Rgb emission = Emission.NONE.color();
    double exponent;
    Optional<Double> roughness = Optional.empty();
    Optional<Double> metallic = Optional.empty();
    double sheen;
    double clearcoat;
    double clearcoatRoughness;
    double anisotropy;

    /** Of the stretched highlight, in turns. */
    double turn;

    long illumination = 2;

    Material material() {
        double opaque =
                opacity.orElseGet(() -> transparency.map(MtlMaterial::opaque).orElse(1.0));
        double through = Math.clamp(1 - opaque, 0.0, 1.0);
        boolean glass = isGlass();
        double transmission = glass && through == 0 ? 1 : through;
        // A surface that only fades, without an index of refraction, must not bend the light.
        double index = ior.orElse(glass || transmission == 0 ? Material.DEFAULT.ior() : 1.0);
        Material plain = Material.DEFAULT
                .withColor(transmission > 0 ? tint(glass) : diffuse)
                .withReflectivity(isPhysical() ? 0 : reflectivity())
                .withRoughness(Math.clamp(roughness.orElse(isPhysical() ? 1.0 : 0.0), 0.0, 1.0))
                .withMetallic(Math.clamp(metallic.orElse(maps.metallic().isPresent() ? 1.0 : 0.0), 0.0, 1.0))
                .withTransmission(transmission)
                .withIor(Math.clamp(index, 1.0, 4.0))
                .withEmission(Emission.NONE.withColor(
                        maps.emission().isPresent() && greatest(emission) == 0 ? new Rgb(1, 1, 1) : emission))
                .withAlpha(maps.alpha().isPresent() ? Alpha.OPAQUE.withMode(Alpha.Mode.BLEND) : Alpha.OPAQUE)
                .withFinish(finish())
                .withMaps(maps.withTexture(texture.map(ImageMap::sampler).orElse(Sampler.DEFAULT)));
        return OptionalValue.with(plain, texture.map(ImageMap::file), Material::withTexture);
    }

    /** MeshLab writes {@code Tr 1} for what is opaque, which would be invisible. */
    private static double opaque(double transparency) {
        return transparency == 1 ? 1 : 1 - transparency;
    }

    private Finish finish() {
        Finish finish = Finish.NONE
                .withClearcoat(Finish.NONE.clearcoat().withPart(clearcoat).withRoughness(clearcoatRoughness))
                .withSheen(Finish.NONE
                        .sheen()
                        .withColor(new Rgb(sheen, sheen, sheen))
                        .withRoughness(SHEEN_ROUGHNESS))
                .withAnisotropy(Finish.NONE
                        .anisotropy()
                        .withStrength(anisotropy)
                        .withRotation(Math.IEEEremainder(turn, 1) * 2 * Math.PI));
        return finish.isNone() ? Finish.NONE : finish;
    }

    /** Whether it has properties of the extension for physically based rendering. */
    private boolean isPhysical() {
        return metallic.isPresent()
                || roughness.isPresent()
                || maps.metallic().isPresent()
                || maps.roughness().isPresent()
                || !finish().isNone();
    }

    private boolean isGlass() {
        return illumination == 4 || illumination == 6 || illumination == 7 || illumination == 9;
    }

    private boolean isMirror() {
        return illumination == 3 || illumination == 5 || illumination == 8;
    }

    /** The filter color if given, else the diffuse color; black glass is taken for a file that gives no color. */
    private Rgb tint(boolean glass) {
        boolean black = diffuse.red() == 0 && diffuse.green() == 0 && diffuse.blue() == 0;
        return filter.orElse(glass && black ? Material.DEFAULT.color() : diffuse);
    }

    private double reflectivity() {
        double strength = specular.map(MtlMaterial::greatest).orElse(0.0);
        if (isMirror()) {
            return Reflectivity.MOST * (specular.isPresent() ? strength : 1);
        }
        if (isGlass() || illumination < 2) {
            return 0;
        }
        return Reflectivity.PLASTIC * strength * Math.clamp(exponent / MAX_EXPONENT * 10, 0.0, 1.0);
    }

    private static double greatest(Rgb color) {
        return Math.max(color.red(), Math.max(color.green(), color.blue()));
    }
}
