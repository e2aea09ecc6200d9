package dev.twister.mesh.gltf;

import dev.twister.mesh.input.OptionalValue;
import dev.twister.mesh.input.Reflectivity;
import dev.twister.mesh.input.TextureLayout;
import dev.twister.mesh.input.Warnings;
import dev.twister.scene.Material;
import dev.twister.scene.Rgb;
import dev.twister.scene.material.Alpha;
import dev.twister.scene.material.Attenuation;
import dev.twister.scene.material.Emission;
import dev.twister.scene.material.ImageMap;
import dev.twister.scene.material.Maps;
import dev.twister.scene.material.Sampler;
import dev.twister.scene.property.MaterialProperties;
import dev.twister.scene.property.SceneLimits;
import java.io.IOException;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/** The materials of a glTF file. */
final class GltfMaterials {
    /**
     * A material and the coordinates of its maps.
     *
     * @param coordinates by {@link Sampler#coordinates}
     */
    record Textured(Material material, List<GltfTextures.Coordinates> coordinates) {}

    private static final Textured DEFAULT =
            new Textured(Material.DEFAULT, List.of(new GltfTextures.Coordinates(0, TextureLayout.PLAIN)));

    private final GltfPlace root;
    private final GltfImages images;
    private final GltfSpecularGlossiness specularGlossiness;
    private final Warnings warnings;
    private final Map<Integer, Textured> read = new HashMap<>();

    GltfMaterials(GltfPlace root, GltfImages images, Warnings warnings) {
        this.root = root;
        this.images = images;
        specularGlossiness = new GltfSpecularGlossiness(images, warnings);
        this.warnings = warnings;
    }

    /** The material of a primitive. */
    Textured of(GltfPlace primitive) throws IOException {
        GltfPlace number = primitive.at("material");
        if (!number.exists()) {
            return DEFAULT;
        }
        GltfPlace materials = root.at("materials");
        int index = number.index(materials);
        Textured known = read.get(index);
        if (known == null) {
            known = read(materials.at(index));
            read.put(index, known);
        }
        return known;
    }

    private Textured read(GltfPlace material) throws IOException {
        GltfTextures textures = new GltfTextures(root, images);
        GltfPlace extensions = material.at("extensions");
        GltfPlace glossy = extensions.at("KHR_materials_pbrSpecularGlossiness");
        Material base = glossy.exists()
                ? specularGlossiness.material(glossy, textures)
                : metallicRoughness(material.at("pbrMetallicRoughness"), textures);
        Material whole = base.withAlpha(alpha(material, base))
                .withEmission(emission(material))
                .withUnlit(extensions.at("KHR_materials_unlit").exists())
                .withIor(Math.clamp(
                        extensions.at("KHR_materials_ior").at("ior").numberOr(Material.DEFAULT.ior()), 1.0, 4.0))
                .withSpecular(extensions
                        .at("KHR_materials_specular")
                        .at("specularFactor")
                        .unitOr(1))
                .withFinish(new GltfFinish(extensions, images, textures, warnings).finish());
        whole = transmission(whole, extensions, textures);
        Maps maps = whole.maps();
        maps = OptionalValue.with(maps, textures.map(material.at("emissiveTexture"), ""), Maps::withEmission);
        maps = OptionalValue.with(maps, textures.map(material.at("normalTexture"), "scale"), Maps::withNormal);
        maps = OptionalValue.with(maps, textures.map(material.at("occlusionTexture"), "strength"), Maps::withOcclusion);
        return new Textured(whole.withMaps(maps), textures.coordinates());
    }

    private static Material metallicRoughness(GltfPlace place, GltfTextures textures) throws IOException {
        double[] color = place.at("baseColorFactor").numbersOr(1, 1, 1, 1);
        Optional<ImageMap> texture = textures.map(place.at("baseColorTexture"), "");
        Optional<ImageMap> roughness = textures.map(place.at("metallicRoughnessTexture"), "");
        Maps maps = Maps.NONE.withTexture(texture.map(ImageMap::sampler).orElse(Sampler.DEFAULT));
        Material plain = Material.DEFAULT
                .withColor(new Rgb(unit(color[0]), unit(color[1]), unit(color[2])))
                .withAlpha(new Alpha(Alpha.Mode.OPAQUE, unit(color[3]), Alpha.OPAQUE.cutoff()))
                .withMetallic(place.at("metallicFactor").unitOr(1))
                .withRoughness(place.at("roughnessFactor").unitOr(1))
                .withMaps(roughness
                        .map(map -> maps.withRoughness(map).withMetallic(map))
                        .orElse(maps));
        return OptionalValue.with(plain, texture.map(ImageMap::file), Material::withTexture);
    }

    private static Alpha alpha(GltfPlace material, Material base) {
        double factor = base.alpha().factor();
        double cutoff = material.at("alphaCutoff").numberOr(Alpha.OPAQUE.cutoff());
        return switch (material.at("alphaMode").textOr("")) {
            case "MASK" -> new Alpha(Alpha.Mode.MASK, factor, cutoff);
            case "BLEND" -> new Alpha(Alpha.Mode.BLEND, factor, cutoff);
            default -> Alpha.OPAQUE;
        };
    }

    private Emission emission(GltfPlace material) {
        double[] factor = material.at("emissiveFactor").numbersOr(0, 0, 0);
        double strength = material.at("extensions")
                .at("KHR_materials_emissive_strength")
                .at("emissiveStrength")
                .numberOr(1);
        double limited = MaterialProperties.EMISSION_STRENGTH.range().clamp(strength);
        if (limited < strength) {
            warnings.add("an emissiveStrength of " + strength + " is limited to " + limited);
        }
        Rgb color = new Rgb(
                SceneLimits.RADIANCE.clamp(factor[0]),
                SceneLimits.RADIANCE.clamp(factor[1]),
                SceneLimits.RADIANCE.clamp(factor[2]));
        Emission emission = Emission.NONE
                .withColor(color)
                .withStrength(limited)
                .withDoubleSided(material.at("doubleSided").isTrue());
        return emission.isNone() ? Emission.NONE : emission;
    }

    private static Material transmission(Material material, GltfPlace extensions, GltfTextures textures)
            throws IOException {
        GltfPlace place = extensions.at("KHR_materials_transmission");
        double transmission = place.at("transmissionFactor").unitOr(0);
        if (transmission == 0) {
            boolean smooth = material.metallic() == 0
                    && material.roughness() == 0
                    && material.finish().isNone();
            // Without metal, roughness and finish the reflectivity alone says that it shines.
            return smooth ? material.withReflectivity(Reflectivity.PLASTIC * material.specular()) : material;
        }
        GltfPlace volume = extensions.at("KHR_materials_volume");
        double[] color = volume.at("attenuationColor").numbersOr(1, 1, 1);
        double distance = volume.at("attenuationDistance").numberOr(0);
        return material.withThinWalled(volume.at("thicknessFactor").numberOr(0) <= 0)
                .withTransmission(
                        material.maps().metallic().isEmpty() ? transmission * (1 - material.metallic()) : transmission)
                .withMaps(OptionalValue.with(
                        material.maps(), textures.map(place.at("transmissionTexture"), ""), Maps::withTransmission))
                .withAttenuation(new Attenuation(
                        new Rgb(unit(color[0]), unit(color[1]), unit(color[2])),
                        distance > 0 ? Optional.of(distance) : Optional.empty()));
    }

    static double unit(double value) {
        return Math.clamp(value, 0.0, 1.0);
    }
}
