package dev.twister.mesh;

import dev.twister.scene.Alpha;
import dev.twister.scene.ImageMap;
import dev.twister.scene.Maps;
import dev.twister.scene.Material;
import dev.twister.scene.Rgb;
import dev.twister.scene.Sampler;
import java.io.IOException;
import java.util.Optional;

/**
 * The archived extension KHR_materials_pbrSpecularGlossiness, converted to metal and roughness as its authors' example
 * converts it.
 */
final class GltfSpecularGlossiness {
    /** Reflectance of plastic at normal incidence. */
    private static final double DIELECTRIC = 0.04;

    private GltfSpecularGlossiness() {}

    static Material material(GltfPlace place, GltfTextures textures, Warnings warnings) throws IOException {
        double[] diffuse = place.at("diffuseFactor").numbersOr(1, 1, 1, 1);
        double[] specular = place.at("specularFactor").numbersOr(1, 1, 1);
        double glossiness = place.at("glossinessFactor").unitOr(1);
        Optional<ImageMap> texture = textures.map(place.at("diffuseTexture"), "");
        boolean mapped = place.at("specularGlossinessTexture").exists();
        if (mapped) {
            warnings.add("textures of KHR_materials_pbrSpecularGlossiness other than the color are not read; those"
                    + " surfaces are rendered rough, without metal");
        }
        double strongest = Math.max(specular[0], Math.max(specular[1], specular[2]));
        double metallic = mapped ? 0 : metallic(luminance(diffuse), luminance(specular), 1 - strongest);
        double[] color = new double[3];
        for (int channel = 0; channel < 3; channel++) {
            double ofDiffuse = diffuse[channel] * (1 - strongest) / (1 - DIELECTRIC) / Math.max(1 - metallic, 1e-6);
            double ofSpecular = (specular[channel] - DIELECTRIC * (1 - metallic)) / Math.max(metallic, 1e-6);
            double part = metallic * metallic;
            double mixed = ofDiffuse + part * (ofSpecular - ofDiffuse);
            color[channel] = GltfMaterials.unit(mapped || metallic == 0 ? diffuse[channel] : mixed);
        }
        Material plain = Material.DEFAULT
                .withColor(new Rgb(color[0], color[1], color[2]))
                .withAlpha(new Alpha(Alpha.Mode.OPAQUE, GltfMaterials.unit(diffuse[3]), Alpha.OPAQUE.cutoff()))
                .withMetallic(metallic)
                .withRoughness(mapped ? 1 : 1 - glossiness)
                .withMaps(Maps.NONE.withTexture(texture.map(ImageMap::sampler).orElse(Sampler.DEFAULT)));
        return Given.with(plain, texture.map(ImageMap::file), Material::withTexture);
    }

    private static double luminance(double[] color) {
        return Math.sqrt(0.299 * color[0] * color[0] + 0.587 * color[1] * color[1] + 0.114 * color[2] * color[2]);
    }

    /** The part of metal that makes both brightnesses: a root of a quadratic equation. */
    private static double metallic(double diffuse, double specular, double left) {
        if (specular < DIELECTRIC) {
            return 0;
        }
        double b = diffuse * left / (1 - DIELECTRIC) + specular - 2 * DIELECTRIC;
        double c = DIELECTRIC - specular;
        double root = Math.sqrt(Math.max(b * b - 4 * DIELECTRIC * c, 0));
        return GltfMaterials.unit((root - b) / (2 * DIELECTRIC));
    }
}
