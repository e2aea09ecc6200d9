package dev.twister.mesh;

import static org.assertj.core.api.Assertions.assertThat;

import dev.twister.scene.Rgb;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Files with a fault in one part, of which the rest is read with a warning. */
class ImperfectMeshesTest {
    private static final String TRIANGLE = "v 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl a\nf 1 2 3\n";
    private static final String PLY_TRIANGLE = """
            element vertex 3
            property float x
            property float y
            property float z
            element face 1
            property list int int vertex_indices
            end_header
            0 0 0
            1 0 0
            0 1 0
            3 0 1 2
            """;
    private static final String LFS_POINTER = "version https://git-lfs.github.com/spec/v1\noid sha256:0\nsize 9\n";

    @TempDir
    Path folder;

    private final List<String> warnings = new ArrayList<>();

    private MeshFile read(String name, String content) {
        return Reading.read(folder, name, content.getBytes(StandardCharsets.UTF_8), 0, warnings);
    }

    static Stream<Arguments> files() {
        String facet = "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\n";
        return Stream.of(
                Arguments.of("a.obj", "mtllib ../a.mtl\n" + TRIANGLE, "the path '../a.mtl' is refused"),
                Arguments.of("a.obj", "mtllib /etc/passwd\n" + TRIANGLE, "the path '/etc/passwd' is refused"),
                Arguments.of("a.obj", "mtllib c:\\a.mtl\n" + TRIANGLE, "the path 'c:\\a.mtl' is refused"),
                Arguments.of("a.obj", "mtllib no.mtl\n" + TRIANGLE, "material library 'no.mtl': file not found"),
                Arguments.of("a.obj", "mtllib .\n" + TRIANGLE, "material library '.': is a folder"),
                Arguments.of("a.obj", TRIANGLE + "v nan 0 1e30\n", "that are not numbers from -1e9 to 1e9: 1"),
                Arguments.of("a.obj", TRIANGLE + "v 0 0 -inf\nf 1 2 4\n", "that are not numbers from -1e9 to 1e9: 1"),
                Arguments.of("a.obj", TRIANGLE + "f 1 1 2\n", "triangles without area: 1; not read"),
                Arguments.of("a.ply", "ply\nformat ascii 1.0\nMade by me\n" + PLY_TRIANGLE, "header line 'Made'"),
                Arguments.of("a.stl", "solid a\n" + facet + "end solid a\n", "'end solid' is read as 'endsolid'"));
    }

    @ParameterizedTest(name = "{2}")
    @MethodSource("files")
    void areReadWithAWarning(String name, String content, String expected) {
        assertThat(read(name, content).shownTriangles()).isEqualTo(1);
        assertThat(warnings).anyMatch(warning -> warning.contains(expected));
    }

    @ParameterizedTest
    @ValueSource(strings = {"../../secret.png", "/etc/secret.png", "C:\\secret.png", "http://a.b/secret.png"})
    void noTextureOutsideTheFolderIsOpened(String texture) throws IOException {
        Files.writeString(folder.resolve("a.mtl"), "newmtl a\nmap_Kd " + texture + "\nKd 1 0 0\n");

        MeshFile file = read("a.obj", "mtllib a.mtl\n" + TRIANGLE);

        assertThat(file.parts().getFirst().material().texture()).isEmpty();
        assertThat(file.parts().getFirst().material().color()).isEqualTo(new Rgb(1, 0, 0));
        assertThat(warnings).singleElement().asString().contains("the path '" + texture + "' is refused");
    }

    @Test
    void aPointerInPlaceOfATextureIsNamed() throws IOException {
        Files.writeString(folder.resolve("a.png"), LFS_POINTER);
        Files.writeString(folder.resolve("a.mtl"), "newmtl a\nmap_Kd a.png\n");

        read("a.obj", "mtllib a.mtl\n" + TRIANGLE);

        assertThat(warnings).singleElement().asString().contains("'a.png': a Git LFS pointer");
    }

    @Test
    void aPointerInPlaceOfAMaterialLibraryIsNamed() throws IOException {
        Files.writeString(folder.resolve("a.mtl"), LFS_POINTER);

        read("a.obj", "mtllib a.mtl\n" + TRIANGLE);

        assertThat(warnings).anyMatch(warning -> warning.contains("'a.mtl': a Git LFS pointer"));
    }

    @Test
    void aDamagedLineOfAMaterialLeavesTheOthers() throws IOException {
        Files.writeString(folder.resolve("a.mtl"), "newmtl a\nNs what\nKd 1 0 0\n");

        MeshFile file = read("a.obj", "mtllib a.mtl\n" + TRIANGLE);

        assertThat(file.parts().getFirst().material().color()).isEqualTo(new Rgb(1, 0, 0));
        assertThat(warnings).singleElement().asString().contains("a.mtl:2: 'what'; expected a number; not read");
    }

    @ParameterizedTest
    @ValueSource(ints = {0, -1, 13})
    void theLengthOfABinaryStlDecidesHowManyTrianglesItHas(int count) {
        byte[] bytes = MeshFiles.stlBinary();
        ByteBuffer.wrap(bytes).order(ByteOrder.LITTLE_ENDIAN).putInt(80, count);

        MeshFile file = Reading.read(folder, "a.stl", bytes, 0, warnings);

        assertThat(file.shownTriangles()).isEqualTo(12);
        assertThat(warnings).singleElement().asString().contains("but the file holds 12, which are read");
    }

    @Test
    void imagesOfGltfThatCannotBeUsedLeaveTheMesh() {
        String text = new String(MeshFiles.gltf(), StandardCharsets.UTF_8)
                .replace(
                        "\"materials\":[{\"pbrMetallicRoughness\":{",
                        "\"extensionsRequired\":[\"KHR_xmp_json_ld\"],\"textures\":[{\"source\":0}],"
                                + "\"images\":[{\"uri\":\"http://a.b/c.png\"}],"
                                + "\"materials\":[{\"pbrMetallicRoughness\":{\"baseColorTexture\":{\"index\":0},");

        MeshFile file = read("a.gltf", text);

        assertThat(file.shownTriangles()).isEqualTo(12);
        assertThat(warnings).singleElement().asString().contains("the path 'http://a.b/c.png' is refused");
    }

    @Test
    void allWarningsAreReportedUpToALimitThatIsNamed() {
        StringBuilder text = new StringBuilder(TRIANGLE);
        for (int i = 0; i < 1000; i++) {
            text.append("unknown").append(i).append('\n');
        }

        read("a.obj", text.toString());

        assertThat(warnings).hasSize(201);
        assertThat(warnings.getLast()).endsWith("a.obj: further warnings are left out");
    }
}
