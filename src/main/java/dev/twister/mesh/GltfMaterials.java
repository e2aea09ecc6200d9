package dev.twister.mesh;

import dev.twister.scene.Material;
import dev.twister.scene.Rgb;
import java.io.IOException;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.Map;
import java.util.Optional;

/** The materials of a glTF file. */
final class GltfMaterials {
    /**
     * A material and the mapping of its texture.
     *
     * @param coordinateSet which set of texture coordinates it uses
     * @param layout transform of these coordinates
     */
    record Textured(Material material, int coordinateSet, TextureLayout layout) {}

    private static final Textured DEFAULT = new Textured(Material.DEFAULT, 0, TextureLayout.PLAIN);

    private final GltfPlace root;
    private final GltfImages images;
    private final Warnings warnings;
    private final Map<Integer, Textured> read = new HashMap<>();

    GltfMaterials(GltfPlace root, GltfImages images, Warnings warnings) {
        this.root = root;
        this.images = images;
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
        GltfPlace metallicRoughness = material.at("pbrMetallicRoughness");
        double[] color = metallicRoughness.at("baseColorFactor").numbersOr(1, 1, 1, 1);
        double roughness = metallicRoughness.at("roughnessFactor").unitOr(1);
        double metallic = metallicRoughness.at("metallicFactor").unitOr(1);
        if (metallicRoughness.at("metallicRoughnessTexture").exists()) {
            warnings.add("textures of metal and roughness are not read; those surfaces are rendered matte");
            metallic = 0;
            roughness = 1;
        }
        warnOfUnused(material);
        GltfPlace extensions = material.at("extensions");
        double transmission = extensions
                .at("KHR_materials_transmission")
                .at("transmissionFactor")
                .unitOr(0);
        double ior = extensions.at("KHR_materials_ior").at("ior").numberOr(Material.DEFAULT.ior());
        boolean faded = transmission == 0 && material.at("alphaMode").textOr("").equals("BLEND") && color[3] < 1;
        GltfPlace texture = metallicRoughness.at("baseColorTexture");
        GltfPlace transform = texture.at("extensions").at("KHR_texture_transform");
        GltfPlace set = transform.at("texCoord").exists() ? transform.at("texCoord") : texture.at("texCoord");
        return new Textured(
                Material.DEFAULT
                        .withColor(new Rgb(unit(color[0]), unit(color[1]), unit(color[2])))
                        .withReflectivity(Reflectivity.of(metallic, roughness) * (1 - transmission))
                        .withRoughness(roughness)
                        .withTransmission(faded ? 1 - unit(color[3]) : transmission * (1 - metallic))
                        // A surface that only fades must not bend the light.
                        .withIor(faded ? 1 : Math.clamp(ior, 1.0, 4.0))
                        .withTexture(picture(texture)),
                (int) Math.min(set.countOr(0), Integer.MAX_VALUE),
                TextureLayout.of(transform));
    }

    private Optional<Path> picture(GltfPlace texture) throws IOException {
        return texture.exists() ? images.ofTexture(texture.at("index").in(root.at("textures"))) : Optional.empty();
    }

    private void warnOfUnused(GltfPlace material) {
        if (material.at("alphaMode").textOr("").equals("MASK")) {
            warnings.add("alpha masks are not read; those surfaces are rendered opaque");
        }
        if (material.at("normalTexture").exists()) {
            warnings.add("normal textures are not read");
        }
        if (material.at("emissiveTexture").exists()
                || brightest(material.at("emissiveFactor").numbersOr(0, 0, 0)) > 0) {
            warnings.add("emission is not read");
        }
    }

    private static double brightest(double[] color) {
        return Math.max(color[0], Math.max(color[1], color[2]));
    }

    private static double unit(double value) {
        return Math.clamp(value, 0.0, 1.0);
    }
}
