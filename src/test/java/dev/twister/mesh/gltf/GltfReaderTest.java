package dev.twister.mesh.gltf;

import static org.assertj.core.api.Assertions.assertThat;

import dev.twister.mesh.MeshFile;
import dev.twister.mesh.MeshFiles;
import dev.twister.mesh.MeshPart;
import dev.twister.mesh.Reading;
import dev.twister.mesh.input.Reflectivity;
import dev.twister.scene.Material;
import dev.twister.scene.Rgb;
import dev.twister.scene.material.Alpha;
import dev.twister.scene.material.ImageMap;
import dev.twister.scene.material.Sampler;
import dev.twister.scene.material.Wrap;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Features of glTF files beyond a plain list of triangles. */
class GltfReaderTest {
    private static final String START = "{\"asset\":{\"version\":\"2.0\"},";
    private static final byte[] PNG = {(byte) 0x89, 'P', 'N', 'G', 13, 10, 26, 10};

    /** Four positions, each followed by texture coordinates as unsigned shorts, then five indices as bytes. */
    private static final byte[] DATA = data();

    @TempDir
    Path folder;

    private final List<String> warnings = new ArrayList<>();

    private static byte[] data() {
        ByteBuffer data = ByteBuffer.allocate(4 * 16 + 8 + 12 + 8).order(ByteOrder.LITTLE_ENDIAN);
        float[][] corners = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}};
        for (float[] corner : corners) {
            data.putFloat(corner[0]).putFloat(corner[1]).putFloat(corner[2]);
            data.putShort((short) (65_535 * corner[0])).putShort((short) (65_535 * corner[1]));
        }
        data.put(new byte[] {0, 1, 2, 3, 0, 0, 0, 0});
        // The sparse accessor's replacement of a position.
        data.putFloat(0).putFloat(0).putFloat(5);
        return data.put(PNG).array();
    }

    private MeshFile read(String primitive, String more) {
        String text = START + "\"meshes\":[{\"primitives\":[" + primitive + "]}],"
                + "\"accessors\":[{\"bufferView\":0,\"componentType\":5126,\"count\":4,\"type\":\"VEC3\"},"
                + "{\"bufferView\":0,\"byteOffset\":12,\"componentType\":5123,\"normalized\":true,\"count\":4,"
                + "\"type\":\"VEC2\"},"
                + "{\"bufferView\":1,\"componentType\":5121,\"count\":4,\"type\":\"SCALAR\"},"
                + "{\"bufferView\":0,\"componentType\":5126,\"count\":4,\"type\":\"VEC3\",\"sparse\":{\"count\":1,"
                + "\"indices\":{\"bufferView\":1,\"byteOffset\":3,\"componentType\":5121},"
                + "\"values\":{\"bufferView\":2}}}],"
                + "\"bufferViews\":[{\"buffer\":0,\"byteLength\":64,\"byteStride\":16},"
                + "{\"buffer\":0,\"byteOffset\":64,\"byteLength\":8},{\"buffer\":0,\"byteOffset\":72,\"byteLength\":12},"
                + "{\"buffer\":0,\"byteOffset\":84,\"byteLength\":8}],"
                + more + "\"buffers\":[{\"byteLength\":92}]}";
        return Reading.read(folder, "a.glb", MeshFiles.glb(text, DATA), 0, warnings);
    }

    @Test
    void strips() {
        MeshFile file = read("{\"attributes\":{\"POSITION\":0},\"indices\":2,\"mode\":5}", "");
        assertThat(Reading.triangles(file))
                .containsExactlyInAnyOrder(
                        "(0.0,0.0,0.0) (0.0,1.0,0.0) (1.0,0.0,0.0)", "(0.0,1.0,0.0) (1.0,1.0,0.0) (1.0,0.0,0.0)");
    }

    @Test
    void fansWithoutIndices() {
        MeshFile file = read("{\"attributes\":{\"POSITION\":0},\"mode\":6}", "");
        assertThat(Reading.triangles(file))
                .containsExactlyInAnyOrder(
                        "(0.0,0.0,0.0) (0.0,1.0,0.0) (1.0,0.0,0.0)", "(0.0,0.0,0.0) (1.0,1.0,0.0) (0.0,1.0,0.0)");
    }

    @Test
    void sparsePositions() {
        MeshFile file = read("{\"attributes\":{\"POSITION\":3},\"mode\":6}", "");
        assertThat(Reading.triangles(file)).contains("(0.0,0.0,-5.0) (0.0,1.0,0.0) (0.0,0.0,0.0)");
    }

    @Test
    void texturesInTheFile() {
        MeshFile file = read(
                "{\"attributes\":{\"POSITION\":0,\"TEXCOORD_0\":1},\"material\":0}",
                "\"materials\":[{\"pbrMetallicRoughness\":{\"metallicFactor\":0,\"baseColorTexture\":{\"index\":0,"
                        + "\"extensions\":{\"KHR_texture_transform\":{\"offset\":[0.5,0],\"scale\":[2,1]}}}}}],"
                        + "\"textures\":[{\"source\":0}],\"images\":[{\"bufferView\":3,\"mimeType\":\"image/png\"}],");
        Path image = folder.resolve("a.glb#0");
        assertThat(file.parts().getFirst().material().texture()).contains(image);
        assertThat(file.embeddedImages().get(image)).isEqualTo(PNG);
        assertThat(file.meshes().getFirst().textureCoordinates()).containsExactly(0.5f, 0, 0.5f, 1, 2.5f, 0);
    }

    @ParameterizedTest
    @CsvSource({"'', 0", "'\"source\":1,', 1"})
    void webpTexturesAreReadUnlessThereIsAnother(String other, int used) {
        MeshFile file = read(
                "{\"attributes\":{\"POSITION\":0,\"TEXCOORD_0\":1},\"material\":0}",
                "\"materials\":[{\"pbrMetallicRoughness\":{\"baseColorTexture\":{\"index\":0}}}],"
                        + "\"textures\":[{" + other + "\"extensions\":{\"EXT_texture_webp\":{\"source\":0}}}],"
                        + "\"images\":[{\"bufferView\":3},{\"bufferView\":3}],");
        assertThat(file.parts().getFirst().material().texture()).contains(folder.resolve("a.glb#" + used));
    }

    @Test
    void emissionIsLimitedAsInSceneFiles() {
        MeshFile file = read(
                "{\"attributes\":{\"POSITION\":0},\"material\":0}",
                "\"materials\":[{\"emissiveFactor\":[1,1e300,0],\"extensions\":"
                        + "{\"KHR_materials_emissive_strength\":{\"emissiveStrength\":1e300}}}],");

        assertThat(file.parts().getFirst().material().emission().strength()).isEqualTo(1e6);
        assertThat(file.parts().getFirst().material().emission().color()).isEqualTo(new Rgb(1, 1e6, 0));
        assertThat(warnings).anyMatch(warning -> warning.contains("emissiveStrength of 1.0E300 is limited to 1000000"));
    }

    @Test
    void materials() {
        MeshFile file = read(
                "{\"attributes\":{\"POSITION\":0},\"material\":0},{\"attributes\":{\"POSITION\":0},\"material\":1},"
                        + "{\"attributes\":{\"POSITION\":0},\"material\":2}",
                "\"materials\":[{\"pbrMetallicRoughness\":{\"metallicFactor\":0,\"roughnessFactor\":0.25,"
                        + "\"baseColorFactor\":[1,0.5,0,1]},\"extensions\":{\"KHR_materials_transmission\":"
                        + "{\"transmissionFactor\":1},\"KHR_materials_ior\":{\"ior\":1.33}}},"
                        + "{\"pbrMetallicRoughness\":{\"roughnessFactor\":0}},"
                        + "{\"alphaMode\":\"BLEND\",\"pbrMetallicRoughness\":{\"baseColorFactor\":[1,1,1,0.25]}}],");
        assertThat(file.parts())
                .extracting(MeshPart::material)
                .containsExactly(
                        Material.DEFAULT
                                .withColor(new Rgb(1, 0.5, 0))
                                .withRoughness(0.25)
                                .withTransmission(1)
                                .withThinWalled(true)
                                .withIor(1.33),
                        Material.DEFAULT.withMetallic(1),
                        Material.DEFAULT
                                .withMetallic(1)
                                .withRoughness(1)
                                .withAlpha(new Alpha(Alpha.Mode.BLEND, 0.25, 0.5)));
    }

    @Test
    void vertexColors() {
        MeshFile file = read("{\"attributes\":{\"POSITION\":0,\"COLOR_0\":0},\"mode\":5}", "");
        assertThat(file.meshes().getFirst().colors())
                .containsExactlyInAnyOrder(0, 0, 0, 1, 1, 0, 0, 1, 0, 1, 0, 1, 1, 1, 0, 1);
    }

    @ParameterizedTest
    @CsvSource({"10497, 33071, REPEAT, CLAMP, false", "33648, 10497, MIRROR, REPEAT, true"})
    void samplers(int across, int down, Wrap expectedAcross, Wrap expectedDown, boolean nearest) {
        MeshFile file = read(
                "{\"attributes\":{\"POSITION\":0,\"TEXCOORD_0\":1},\"material\":0}",
                "\"materials\":[{\"pbrMetallicRoughness\":{\"baseColorTexture\":{\"index\":0}}}],"
                        + "\"samplers\":[{\"wrapS\":" + across + ",\"wrapT\":" + down
                        + (nearest ? ",\"magFilter\":9728" : "") + "}],"
                        + "\"textures\":[{\"source\":0,\"sampler\":0}],"
                        + "\"images\":[{\"bufferView\":3,\"mimeType\":\"image/png\"}],");
        assertThat(file.parts().getFirst().material().maps().texture())
                .isEqualTo(new Sampler(expectedAcross, expectedDown, nearest, 0));
    }

    /** Two maps with transforms of their own need two sets of texture coordinates. */
    @Test
    void eachMapHasItsTransform() {
        MeshFile file = read(
                "{\"attributes\":{\"POSITION\":0,\"TEXCOORD_0\":1},\"material\":0}",
                "\"materials\":[{\"pbrMetallicRoughness\":{\"baseColorTexture\":{\"index\":0}},"
                        + "\"normalTexture\":{\"index\":0,\"scale\":0.5,\"extensions\":{\"KHR_texture_transform\":"
                        + "{\"offset\":[3,4]}}}}],"
                        + "\"textures\":[{\"source\":0}],\"images\":[{\"bufferView\":3,\"mimeType\":\"image/png\"}],");
        Sampler second = new Sampler(Wrap.REPEAT, Wrap.REPEAT, false, 1);
        assertThat(file.parts().getFirst().material().maps().normal())
                .contains(new ImageMap(folder.resolve("a.glb#0"), second, 0.5));
        assertThat(file.meshes().getFirst().textureCoordinates()).containsExactly(0, 0, 0, 1, 1, 0, 3, 4, 3, 5, 4, 4);
    }

    @Test
    void specularAndGlossinessBecomeMetalAndRoughness() {
        MeshFile file = read(
                "{\"attributes\":{\"POSITION\":0},\"material\":0}",
                "\"materials\":[{\"extensions\":{\"KHR_materials_pbrSpecularGlossiness\":{\"diffuseFactor\":[1,0,0,1],"
                        + "\"specularFactor\":[0,0,0],\"glossinessFactor\":0.25}}}],");
        assertThat(file.parts().getFirst().material())
                .isEqualTo(Material.DEFAULT.withColor(new Rgb(1, 0, 0)).withRoughness(0.75));
    }

    @ParameterizedTest
    @CsvSource({"0.5, 0.25, 0.25", "0, 0.25, 0.25", "0.5, 1.5, 1", "1, -1, 0"})
    void specularIsAFactorThatLeavesTheIndex(double roughness, double factor, double expected) {
        MeshFile file = read(
                "{\"attributes\":{\"POSITION\":0},\"material\":0}",
                "\"materials\":[{\"pbrMetallicRoughness\":{\"metallicFactor\":0,\"roughnessFactor\":" + roughness
                        + "},\"extensions\":{\"KHR_materials_ior\":{\"ior\":1.4},"
                        + "\"KHR_materials_specular\":{\"specularFactor\":" + factor + "}}}],");
        Material material = file.parts().getFirst().material();
        assertThat(material.ior()).isEqualTo(1.4);
        assertThat(material.specular()).isEqualTo(expected);
        assertThat(material.reflectivity()).isEqualTo(roughness == 0 ? Reflectivity.PLASTIC * expected : 0);
    }

    @Test
    void meshesThatSeveralNodesShowAreKeptOnce() {
        MeshFile file = read(
                "{\"attributes\":{\"POSITION\":0}}",
                "\"scenes\":[{\"nodes\":[0]},{\"nodes\":[1,2,3]}],\"scene\":1,\"nodes\":[{},{\"mesh\":0},"
                        + "{\"mesh\":0,\"name\":\"two\",\"rotation\":[0,0.70710678118,0,0.70710678118]},"
                        + "{\"mesh\":0,\"matrix\":[0,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1]}],");
        assertThat(file.meshes()).hasSize(1);
        assertThat(file.parts()).extracting(MeshPart::name).containsExactly("", "two");
        // A quarter turn about y, counterclockwise seen from above, maps x to the back of the viewer.
        assertThat(file.parts().get(1).placement().axisX().z()).isBetween(0.999, 1.001);
        assertThat(warnings)
                .anyMatch(warning -> warning.contains("several scenes"))
                .anyMatch(warning -> warning.contains("$.nodes[3] is flat"));
    }

    @Test
    void saysWhatIsNotRead() {
        read(
                "{\"attributes\":{\"POSITION\":0},\"targets\":[{\"POSITION\":0}]},{\"attributes\":{\"POSITION\":0},\"mode\":1}",
                "\"animations\":[{}],\"skins\":[{}],\"extensionsUsed\":[\"EXT_odd\"],");
        assertThat(warnings)
                .hasSize(2)
                .allMatch(warning -> warning.startsWith(folder.resolve("a.glb") + ": "))
                .anyMatch(warning -> warning.contains("EXT_odd"))
                .anyMatch(warning -> warning.contains("points or lines"));
    }

    @Test
    void buffersBesideTheFile() throws IOException {
        Files.write(folder.resolve("my data.bin"), DATA);
        String text = START + "\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":0}}]}],"
                + "\"accessors\":[{\"bufferView\":0,\"componentType\":5126,\"count\":3,\"type\":\"VEC3\"}],"
                + "\"bufferViews\":[{\"buffer\":0,\"byteLength\":64,\"byteStride\":16}],"
                + "\"buffers\":[{\"byteLength\":92,\"uri\":\"my%20data.bin\"}]}";
        assertThat(Reading.read(folder, "a.gltf", text.getBytes(StandardCharsets.UTF_8), 0)
                        .shownTriangles())
                .isEqualTo(1);
    }
}
