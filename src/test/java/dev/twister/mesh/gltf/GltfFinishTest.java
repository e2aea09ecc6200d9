package dev.twister.mesh.gltf;

import static org.assertj.core.api.Assertions.assertThat;

import dev.twister.mesh.MeshFile;
import dev.twister.mesh.Reading;
import dev.twister.scene.Material;
import dev.twister.scene.Rgb;
import dev.twister.scene.material.Finish;
import dev.twister.scene.material.ImageMap;
import dev.twister.scene.material.Sampler;
import dev.twister.scene.material.Wrap;
import java.awt.image.BufferedImage;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Base64;
import java.util.List;
import java.util.Optional;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** The extensions of glTF's material that path tracing alone shows. */
class GltfFinishTest {
    private static final String TEXTURE = "{\"index\":0}";
    private static final String CLEAR = "\"KHR_materials_clearcoat\":{\"clearcoatFactor\":0.5}";

    @TempDir
    Path folder;

    private final List<String> warnings = new ArrayList<>();

    @Test
    void everyExtensionIsRead() {
        Finish finish = finish("""
                "KHR_materials_clearcoat":{"clearcoatFactor":0.1,"clearcoatRoughnessFactor":0.2,"clearcoatTexture":#,
                  "clearcoatRoughnessTexture":#,"clearcoatNormalTexture":{"index":0,"scale":0.3}},
                "KHR_materials_sheen":{"sheenColorFactor":[0.1,0.2,0.3],"sheenRoughnessFactor":0.4,
                  "sheenColorTexture":#,"sheenRoughnessTexture":#},
                "KHR_materials_anisotropy":{"anisotropyStrength":0.5,"anisotropyRotation":7,"anisotropyTexture":#},
                "KHR_materials_specular":{"specularFactor":0.6,"specularColorFactor":[0.7,0.8,900],
                  "specularTexture":#,"specularColorTexture":#},
                "KHR_materials_iridescence":{"iridescenceFactor":0.11,"iridescenceIor":1.12,
                  "iridescenceThicknessMinimum":130,"iridescenceThicknessMaximum":14000,"iridescenceTexture":#,
                  "iridescenceThicknessTexture":#},
                "KHR_materials_dispersion":{"dispersion":0.15},
                "KHR_materials_diffuse_transmission":{"diffuseTransmissionFactor":0.16,
                  "diffuseTransmissionColorFactor":[0.17,0.18,0.19],"diffuseTransmissionTexture":#,
                  "diffuseTransmissionColorTexture":#}
                """);
        Optional<ImageMap> map = Optional.of(map("a.gltf#0"));
        Optional<ImageMap> alpha = Optional.of(map("a.gltf#alpha-0"));
        assertThat(finish)
                .isEqualTo(new Finish(
                        new Finish.Clearcoat(0.1, 0.2, map, map, map.map(normal -> normal.withScale(0.3))),
                        new Finish.Sheen(new Rgb(0.1, 0.2, 0.3), 0.4, map, alpha),
                        new Finish.Anisotropy(0.5, 7 - 2 * Math.PI, map),
                        new Finish.Specular(new Rgb(0.7, 0.8, 100), alpha, map),
                        new Finish.Film(0.11, 1.12, 130, 10_000, map, map),
                        0.15,
                        new Finish.Through(0.16, new Rgb(0.17, 0.18, 0.19), alpha, map)));
        assertThat(warnings).isEmpty();
    }

    @Test
    void aMaterialWithAFinishHasNoReflectivity() {
        Material coated = material("\"extensions\":{" + CLEAR + "}");
        assertThat(coated.reflectivity()).isZero();
        assertThat(coated.isByFresnel()).isTrue();
        assertThat(material("\"extensions\":{}").reflectivity()).isPositive();
    }

    @Test
    void whatHasNoEffectIsNoFinish() {
        assertThat(finish("""
                "KHR_materials_clearcoat":{"clearcoatRoughnessFactor":1,"clearcoatTexture":#},
                "KHR_materials_sheen":{"sheenRoughnessFactor":1},
                "KHR_materials_iridescence":{"iridescenceIor":2},
                "KHR_materials_specular":{"specularFactor":0.5},
                "KHR_materials_anisotropy":{},"KHR_materials_dispersion":{},
                "KHR_materials_diffuse_transmission":{"diffuseTransmissionColorFactor":[1,0,0]}
                """)).isEqualTo(Finish.NONE);
    }

    @ParameterizedTest
    @ValueSource(strings = {"KHR_materials_unlit", "KHR_materials_pbrSpecularGlossiness"})
    void materialsOfAnotherKindHaveNone(String other) {
        assertThat(finish(CLEAR + ",\"" + other + "\":{}")).isEqualTo(Finish.NONE);
    }

    @Test
    void numbersAreLimitedAsInSceneFiles() {
        Finish finish = finish("""
                "KHR_materials_clearcoat":{"clearcoatFactor":2,"clearcoatRoughnessFactor":-1},
                "KHR_materials_sheen":{"sheenColorFactor":[2,-1,0.5]},
                "KHR_materials_iridescence":{"iridescenceFactor":1,"iridescenceIor":9},
                "KHR_materials_dispersion":{"dispersion":1e9}
                """);
        assertThat(finish.clearcoat().part()).isEqualTo(1);
        assertThat(finish.clearcoat().roughness()).isZero();
        assertThat(finish.sheen().color()).isEqualTo(new Rgb(1, 0, 0.5));
        assertThat(finish.film().ior()).isEqualTo(4);
        assertThat(finish.dispersion()).isEqualTo(20);
    }

    @Test
    void mapsHaveTheirPlacesAndSamplers() {
        Finish finish = finish("""
                "KHR_materials_clearcoat":{"clearcoatFactor":1,"clearcoatTexture":{"index":1,"texCoord":1}},
                "KHR_materials_sheen":{"sheenColorFactor":[1,1,1],"sheenRoughnessTexture":{"index":1,"extensions":
                  {"KHR_texture_transform":{"offset":[0.5,0]}}}}
                """);
        assertThat(finish.clearcoat().map().orElseThrow().sampler())
                .isEqualTo(new Sampler(Wrap.CLAMP, Wrap.MIRROR, true, 0));
        assertThat(finish.sheen().roughnessMap().orElseThrow().sampler())
                .isEqualTo(new Sampler(Wrap.CLAMP, Wrap.MIRROR, true, 1));
    }

    @Test
    void theAlphaChannelBecomesAGrayImage() throws IOException {
        MeshFile file = read("\"extensions\":{\"KHR_materials_specular\":{\"specularTexture\":" + TEXTURE + "}}", 77);
        byte[] picture = file.embeddedImages().get(folder.resolve("a.gltf#alpha-0"));
        BufferedImage alpha = ImageIO.read(new ByteArrayInputStream(picture));
        assertThat(alpha.getRGB(0, 0)).isEqualTo(0xff4d4d4d);
        assertThat(alpha.getColorModel().hasAlpha()).isFalse();
    }

    @Test
    void anImageWithoutAlphaChangesNothing() {
        MeshFile file = read("\"extensions\":{\"KHR_materials_specular\":{\"specularTexture\":" + TEXTURE + "}}", -1);
        assertThat(file.parts().getFirst().material().finish()).isEqualTo(Finish.NONE);
        assertThat(warnings).isEmpty();
    }

    private ImageMap map(String image) {
        return ImageMap.of(folder.resolve(image));
    }

    private Finish finish(String extensions) {
        return material("\"extensions\":{" + extensions.replace("#", TEXTURE) + "}")
                .finish();
    }

    private Material material(String json) {
        return read("\"pbrMetallicRoughness\":{\"metallicFactor\":0,\"roughnessFactor\":0}," + json, 77)
                .parts()
                .getFirst()
                .material();
    }

    /** @param alpha of the only texel of the image, or -1 if it has none */
    private MeshFile read(String material, int alpha) {
        ByteBuffer corners = ByteBuffer.allocate(60).order(ByteOrder.LITTLE_ENDIAN);
        for (float number : new float[] {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 1}) {
            corners.putFloat(number);
        }
        String json = """
                {"asset":{"version":"2.0"},"extensionsUsed":["KHR_materials_clearcoat","KHR_materials_sheen",
                "KHR_materials_anisotropy","KHR_materials_specular","KHR_materials_iridescence",
                "KHR_materials_dispersion","KHR_materials_diffuse_transmission"],
                "meshes":[{"primitives":[{"attributes":{"POSITION":0,"TEXCOORD_0":1},"material":0}]}],
                "accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3"},
                {"bufferView":1,"componentType":5126,"count":3,"type":"VEC2"}],
                "bufferViews":[{"buffer":0,"byteLength":36},{"buffer":0,"byteOffset":36,"byteLength":24}],
                "buffers":[{"byteLength":60,"uri":"data:application/octet-stream;base64,%s"}],
                "samplers":[{"wrapS":33071,"wrapT":33648,"magFilter":9728}],
                "textures":[{"source":0},{"source":0,"sampler":0}],
                "images":[{"uri":"data:image/png;base64,%s"}],
                "materials":[{%s}]}
                """.formatted(text(corners.array()), text(png(alpha)), material);
        return Reading.read(folder, "a.gltf", json.getBytes(StandardCharsets.UTF_8), 0, warnings);
    }

    private static byte[] png(int alpha) {
        BufferedImage image =
                new BufferedImage(1, 1, alpha < 0 ? BufferedImage.TYPE_INT_RGB : BufferedImage.TYPE_INT_ARGB);
        image.setRGB(0, 0, alpha << 24 | 0x102030);
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        try {
            ImageIO.write(image, "png", bytes);
        } catch (IOException failure) {
            throw new UncheckedIOException(failure);
        }
        return bytes.toByteArray();
    }

    private static String text(byte[] bytes) {
        return Base64.getEncoder().encodeToString(bytes);
    }
}
