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
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** The extensions of glTF's material that path tracing alone shows. */
class GltfFinishTest {
    private static final String CLEAR = "\"KHR_materials_clearcoat\":{\"clearcoatFactor\":0.5}";

    @TempDir
    Path folder;

    private final List<String> warnings = new ArrayList<>();

    @Test
    void everyExtensionIsRead() {
        Finish finish = finish(FinishedGltf.ALL);
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
        MeshFile file = read(
                "\"extensions\":{\"KHR_materials_specular\":{\"specularTexture\":" + FinishedGltf.TEXTURE + "}}", 77);
        byte[] picture = file.embeddedImages().get(folder.resolve("a.gltf#alpha-0"));
        BufferedImage alpha = ImageIO.read(new ByteArrayInputStream(picture));
        assertThat(alpha.getRGB(0, 0)).isEqualTo(0xff4d4d4d);
        assertThat(alpha.getColorModel().hasAlpha()).isFalse();
    }

    @Test
    void anImageWithoutAlphaChangesNothing() {
        MeshFile file = read(
                "\"extensions\":{\"KHR_materials_specular\":{\"specularTexture\":" + FinishedGltf.TEXTURE + "}}", -1);
        assertThat(file.parts().getFirst().material().finish()).isEqualTo(Finish.NONE);
        assertThat(warnings).isEmpty();
    }

    private ImageMap map(String image) {
        return ImageMap.of(folder.resolve(image));
    }

    private Finish finish(String extensions) {
        return material("\"extensions\":{" + extensions.replace("#", FinishedGltf.TEXTURE) + "}")
                .finish();
    }

    private Material material(String json) {
        return read("\"pbrMetallicRoughness\":{\"metallicFactor\":0,\"roughnessFactor\":0}," + json, 77)
                .parts()
                .getFirst()
                .material();
    }

    private MeshFile read(String material, int alpha) {
        String json = FinishedGltf.of(material, alpha);
        return Reading.read(folder, "a.gltf", json.getBytes(StandardCharsets.UTF_8), 0, warnings);
    }
}
