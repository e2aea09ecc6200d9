package dev.twister.mesh;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

/** Rejected files and the messages for them. */
class RefusedMeshesTest {
    private static final String TRIANGLE = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
    private static final String GLTF = "{\"asset\":{\"version\":\"2.0\"},";

    @TempDir
    Path folder;

    static Stream<Arguments> files() {
        return Stream.of(
                Arguments.of("a.obj", "", "an empty file"),
                Arguments.of("a.xyz", "hello", "not a mesh by its first bytes or its name"),
                Arguments.of("a.obj", "# nothing\n", "holds no triangles"),
                Arguments.of("a.obj", "v 0 0 0\nf 1 1 1\n", "holds no triangles but 1 without an area"),
                Arguments.of("a.obj", "v 0 0\n", ":1: the line ends; expected a number"),
                Arguments.of("a.obj", "v 0 0 nan\nf 1 1 1\n", "holds no triangles but 1 without an area"),
                Arguments.of("a.obj", "v 0 0,5 1\n", ":1: '0,5'; expected a number with a decimal point"),
                Arguments.of("a.obj", "version https://git-lfs.github.com/spec/v1\n", "a Git LFS pointer"),
                Arguments.of("a.glb", "version https://git-lfs.github.com/spec/v1\n", "a Git LFS pointer"),
                Arguments.of("a.obj", "v 0 0 x\n", ":1: 'x'; expected a number"),
                Arguments.of(
                        "a.obj", "v 0 0 0\n\nf 1 2 3\n", ":3: vertex 2 is not there; above this line there are 1 to 1"),
                Arguments.of("a.obj", "v 0 0 0\nf -2 1 1\n", ":2: vertex -2 is not there"),
                Arguments.of("a.obj", "#\0\nv\0 \0", ":2: bytes of 0; expected text in ASCII or UTF-8"),
                Arguments.of("a.obj", "v 0 0 0\nf 1:1 1 1\n", ":2: ':1'; expected a corner like"),
                Arguments.of("a.obj", "v 0 0 0\nf 4294967297 1 1\n", ":2: vertex 4294967297 is not there"),
                Arguments.of("a.ply", "ply\nformat ascii 1.0\n", ":3: truncated: the file ends in the header"),
                Arguments.of("a.ply", "ply\nformat binary_middle 1.0\n", ":2: unknown format 'binary_middle'"),
                Arguments.of(
                        "a.ply", ply(2147483648L, ""), "truncated: the header says 2147483648 of the element 'vertex'"),
                Arguments.of("a.ply", ply(-1, ""), "there are -1 of the element 'vertex'; expected 0 or more"),
                Arguments.of(
                        "a.ply",
                        ply(3, "0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n"),
                        ":13: face 0 has a vertex 3; they are 0 to 2"),
                Arguments.of(
                        "a.ply", ply(3, "0 0 0\n1 0 0\n0 1 0\n4000000 0 1 3\n"), "a list 'vertex_indices' of 4000000"),
                Arguments.of(
                        "a.ply", ply(3, "0 0 0\n1 0 0\n0 1 0\n3 0 1\n"), "truncated: the file ends before its last"),
                Arguments.of("a.stl", "solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\n", "expected 'vertex'"),
                Arguments.of("a.stl", "solid\nendsolid\n", "holds no triangles"),
                Arguments.of("a.stl", "what", "truncated: the file ends in the header"),
                Arguments.of("a.gltf", "{", "not valid JSON"),
                Arguments.of("a.gltf", "[]", "holds no object"),
                Arguments.of("a.gltf", "[".repeat(100_000), "not valid JSON"),
                Arguments.of(
                        "a.gltf", "{\"asset\":{\"version\":\"1.0\"}}", "$.asset.version is '1.0'; glTF 2.0 is read"),
                Arguments.of("a.gltf", "{}", "$.asset.version is missing"),
                Arguments.of(
                        "a.gltf",
                        GLTF + "\"extensionsRequired\":[\"KHR_draco_mesh_compression\"]}",
                        "is 'KHR_draco_mesh_compression', which is not read; decompress the file: npx @gltf-transform"),
                Arguments.of(
                        "a.gltf",
                        GLTF + "\"scenes\":[{\"nodes\":[0]}],\"nodes\":[{\"children\":[1]},{\"children\":[0]}]}",
                        "$.nodes[0] is in the scene twice, or its own ancestor"),
                Arguments.of(
                        "a.gltf",
                        GLTF + "\"scenes\":[{\"nodes\":[0]}],\"nodes\":[{\"children\":[1,1]},{}]}",
                        "$.nodes[1] is in the scene twice"),
                Arguments.of("a.gltf", GLTF + "\"scenes\":[{\"nodes\":[7]}]}", "nodes[0] is 7; $.nodes has 0 items"),
                Arguments.of("a.gltf", buffer("\"../a.bin\""), "the path '../a.bin' is refused"),
                Arguments.of("a.gltf", buffer("\"%2e%2e/a.bin\""), "the path '../a.bin' is refused"),
                Arguments.of("a.gltf", buffer("\"/a.bin\""), "is refused"),
                Arguments.of("a.gltf", buffer("\"https://a/b.bin\""), "is refused"),
                Arguments.of("a.gltf", buffer("\"a.bin\""), "file not found"),
                Arguments.of("a.gltf", buffer("\"data:;base64,A?\""), "is a broken data URI"),
                Arguments.of("a.gltf", buffer("\"data:;base64,AAAA\""), "is said to have 36 bytes, but has 3"),
                Arguments.of("a.gltf", buffer("3"), "$.buffers[0].uri is no string"));
    }

    private static String ply(long vertices, String rows) {
        return "ply\nformat ascii 1.0\nelement vertex " + vertices
                + "\nproperty float x\nproperty float y\nproperty float z\nelement face 1\n"
                + "property list int int vertex_indices\nend_header\n" + rows;
    }

    private static String buffer(String uri) {
        return GLTF + "\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":0}}]}],"
                + "\"accessors\":[{\"bufferView\":0,\"componentType\":5126,\"count\":3,\"type\":\"VEC3\"}],"
                + "\"bufferViews\":[{\"buffer\":0,\"byteLength\":36}],\"buffers\":[{\"byteLength\":36,\"uri\":" + uri
                + "}]}";
    }

    @ParameterizedTest(name = "{2}")
    @MethodSource("files")
    void sayWhatIsWrong(String name, String content, String expected) {
        assertThatThrownBy(() -> Reading.read(folder, name, content))
                .isInstanceOf(MeshException.class)
                .hasMessageStartingWith(folder.resolve(name).toString())
                .hasMessageContaining(expected)
                .message()
                .doesNotContain("\n")
                .hasSizeLessThan(400);
    }

    @Test
    void aFileThatIsNotThere() {
        assertThatThrownBy(() -> MeshReader.read(folder.resolve("no.obj"), 0, _ -> {}))
                .isInstanceOf(MeshException.class)
                .hasMessage(folder.resolve("no.obj") + ": file not found");
    }

    @Test
    void aFolder() throws IOException {
        Path path = Files.createDirectory(folder.resolve("a.obj"));
        assertThatThrownBy(() -> MeshReader.read(path, 0, _ -> {}))
                .isInstanceOf(MeshException.class)
                .hasMessage(path + ": is a folder, but must be a file");
    }

    @Test
    void binaryStlThatIsNone() {
        ByteBuffer file = ByteBuffer.allocate(84 + 60)
                .order(ByteOrder.LITTLE_ENDIAN)
                .putInt(80, -1)
                .putFloat(96, Float.NaN);
        assertThatThrownBy(() -> Reading.read(folder, "a.stl", file.array(), 0))
                .isInstanceOf(MeshException.class)
                .hasMessageContaining("byte 80: truncated, or not STL");
    }

    @Test
    void aLongWord() {
        byte[] line = ("usemtl " + "a".repeat(1 << 20) + "\n").getBytes(StandardCharsets.UTF_8);
        assertThatThrownBy(() -> Reading.read(folder, "a.obj", line, 0))
                .isInstanceOf(MeshException.class)
                .hasMessageContaining(":1: a word or name of 1048576 bytes; at most 4096 are read");
        assertThat(Reading.read(folder, "a.obj", "#" + "a".repeat(1 << 20) + "\n" + TRIANGLE)
                        .shownTriangles())
                .isEqualTo(1);
    }
}
