package dev.twister.mesh.gltf;

import dev.twister.mesh.input.OptionalValue;
import dev.twister.mesh.input.Warnings;
import dev.twister.scene.Material;
import dev.twister.scene.Rgb;
import dev.twister.scene.material.Alpha;
import dev.twister.scene.material.ImageMap;
import dev.twister.scene.material.Maps;
import dev.twister.scene.material.Sampler;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.channels.ClosedByInterruptException;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.Map;
import java.util.Optional;

/** The archived extension KHR_materials_pbrSpecularGlossiness, converted to metal and roughness. */
final class GltfSpecularGlossiness {
    private final GlossyImages images;
    private final Warnings warnings;

    GltfSpecularGlossiness(GltfImages images, Warnings warnings) {
        this.images = new GlossyImages(images);
        this.warnings = warnings;
    }

    Material material(GltfPlace place, GltfTextures textures) throws IOException {
        double[] diffuse = place.at("diffuseFactor").numbersOr(1, 1, 1, 1);
        double[] specular = place.at("specularFactor").numbersOr(1, 1, 1);
        double glossiness = place.at("glossinessFactor").unitOr(1);
        Optional<ImageMap> texture = textures.map(place.at("diffuseTexture"), "");
        Optional<ImageMap> glossy = textures.map(place.at("specularGlossinessTexture"), "");
        GlossyTexels.Factors factors = new GlossyTexels.Factors(
                new Rgb(diffuse[0], diffuse[1], diffuse[2]),
                Math.clamp(diffuse[3], 0.0, 1.0),
                new Rgb(specular[0], specular[1], specular[2]),
                glossiness);
        if (glossy.isPresent()) {
            try {
                return mapped(texture, glossy.get(), factors);
            } catch (ClosedByInterruptException canceled) {
                throw canceled;
            } catch (IOException problem) {
                warnings.add(place.at("specularGlossinessTexture") + ": " + problem.getMessage()
                        + "; rendered rough, without metal");
            }
        }
        MetalOfSpecular metal = glossy.isPresent()
                ? new MetalOfSpecular(factors.diffuse(), 0)
                : MetalOfSpecular.of(factors.diffuse(), factors.specular());
        Material plain = Material.DEFAULT
                .withColor(metal.color())
                .withAlpha(new Alpha(Alpha.Mode.OPAQUE, factors.opacity(), Alpha.OPAQUE.cutoff()))
                .withMetallic(metal.metallic())
                .withRoughness(glossy.isPresent() ? 1 : 1 - glossiness)
                .withMaps(Maps.NONE.withTexture(texture.map(ImageMap::sampler).orElse(Sampler.DEFAULT)));
        return OptionalValue.with(plain, texture.map(ImageMap::file), Material::withTexture);
    }

    private Material mapped(Optional<ImageMap> texture, ImageMap glossy, GlossyTexels.Factors factors)
            throws IOException {
        if (texture.isPresent() && !texture.get().sampler().equals(glossy.sampler())) {
            throw new IOException("is not placed as the diffuse texture");
        }
        GlossyImages.Converted converted = images.of(texture.map(ImageMap::file), glossy.file(), factors);
        ImageMap metal = new ImageMap(converted.metal(), glossy.sampler(), 1);
        return Material.DEFAULT
                .withMetallic(1)
                .withRoughness(1)
                .withTexture(converted.color())
                .withMaps(Maps.NONE
                        .withTexture(glossy.sampler())
                        .withRoughness(metal)
                        .withMetallic(metal));
    }

    /** Converted textures of a glTF file with KHR_materials_pbrSpecularGlossiness, each made once. */
    private static final class GlossyImages {
        private final GltfImages images;
        private final Map<Key, Converted> made = new HashMap<>();

        /** Paths of images that count as embedded in the file. */
        record Converted(Path color, Path metal) {}

        private record Key(Optional<Path> diffuse, Path glossy, GlossyTexels.Factors factors) {}

        GlossyImages(GltfImages images) {
            this.images = images;
        }

        /**
         * Converts two textures.
         *
         * @throws IOException if one cannot be read, or there are too many
         */
        Converted of(Optional<Path> diffuse, Path glossy, GlossyTexels.Factors factors) throws IOException {
            Key key = new Key(diffuse, glossy, factors);
            Converted known = made.get(key);
            if (known == null) {
                Optional<BufferedImage> shown =
                        diffuse.isPresent() ? Optional.of(images.decoded(diffuse.get())) : Optional.empty();
                GlossyTexels texels = GlossyTexels.of(shown, images.decoded(glossy), factors);
                String name = "converted-" + made.size();
                known = new Converted(
                        images.add(name + "-color", texels.color()), images.add(name + "-metal", texels.metal()));
                made.put(key, known);
            }
            return known;
        }
    }
}
