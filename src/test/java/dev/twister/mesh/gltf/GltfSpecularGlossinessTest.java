package dev.twister.mesh.gltf;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import dev.twister.mesh.MeshFile;
import dev.twister.mesh.Reading;
import dev.twister.scene.Material;
import dev.twister.scene.Rgb;
import dev.twister.scene.material.ImageMap;
import java.awt.image.BufferedImage;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Base64;
import java.util.List;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Textures of KHR_materials_pbrSpecularGlossiness. */
class GltfSpecularGlossinessTest {
    @TempDir
    private Path folder;

    private final List<String> warnings = new ArrayList<>();

    private MeshFile read(String place, int[] diffuse, int[] glossy) throws IOException {
        String text = """
                {"asset": {"version": "2.0"},
                "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "material": 0}]}],
                "materials": [{"extensions": {"KHR_materials_pbrSpecularGlossiness": {
                  "diffuseTexture": {"index": 0}, "specularGlossinessTexture": {"index": 1%s}}}}],
                "textures": [{"source": 0}, {"source": 1}],
                "images": [{"uri": "data:image/png;base64,%s"}, {"uri": "data:image/png;base64,%s"}],
                "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"}],
                "bufferViews": [{"buffer": 0, "byteLength": 36}],
                "buffers": [{"byteLength": 36,
                  "uri": "data:;base64,AACgwAAAAAAAAAAAAACgQAAAAAAAAAAAAAAAAAAAIEEAAAAA"}]}
                """.formatted(place, png(diffuse), png(glossy));
        return Reading.read(folder, "a.gltf", text.getBytes(StandardCharsets.UTF_8), 0, warnings);
    }

    private static String png(int[] row) throws IOException {
        BufferedImage image = new BufferedImage(row.length, 1, BufferedImage.TYPE_INT_ARGB);
        image.setRGB(0, 0, row.length, 1, row, 0, row.length);
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        ImageIO.write(image, "png", bytes);
        return Base64.getEncoder().encodeToString(bytes.toByteArray());
    }

    private static int[] texels(MeshFile file, Path image) throws IOException {
        BufferedImage read =
                ImageIO.read(new ByteArrayInputStream(file.embeddedImages().get(image)));
        return read.getRGB(0, 0, read.getWidth(), 1, null, 0, read.getWidth());
    }

    @Test
    void eachTexelBecomesMetalOrPlastic() throws IOException {
        // Half transparent, glossy plastic; rough gold.
        MeshFile file = read("", new int[] {0x80c04020, 0xff000000}, new int[] {0xff000000, 0x33ffe29b});
        Material material = file.parts().getFirst().material();
        ImageMap metal = material.maps().metallic().orElseThrow();

        assertThat(texels(file, material.texture().orElseThrow())).containsExactly(0x80c04020, 0xffffe29b);
        assertThat(texels(file, metal.file())).containsExactly(0xff000000, 0xff00ccff);
        assertThat(material.maps().roughness()).contains(metal);
        assertThat(material.metallic() * material.roughness()).isOne();
    }

    @Test
    void texturesThatArePlacedApartAreSaid() throws IOException {
        MeshFile file = read(", \"texCoord\": 1", new int[] {-1}, new int[] {-1});

        assertThat(file.parts().getFirst().material().metallic()).isZero();
        assertThat(warnings)
                .anyMatch(
                        warning -> warning.endsWith(
                                "specularGlossinessTexture: is not placed as the diffuse texture; rendered rough, without metal"));
    }

    @Test
    void colorsBetweenPlasticAndMetalAreBoth() {
        MetalOfSpecular converted = MetalOfSpecular.of(new Rgb(0.3, 0.3, 0.3), new Rgb(0.3, 0.3, 0.3));

        assertThat(converted.metallic()).isBetween(0.3, 0.9);
        // Its reflectance is the specular color.
        double reflectance = 0.04 * (1 - converted.metallic())
                + converted.metallic() * converted.color().red();
        assertThat(reflectance).isCloseTo(0.3, within(0.1));
    }
}
