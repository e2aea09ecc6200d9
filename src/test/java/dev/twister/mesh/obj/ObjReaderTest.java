package dev.twister.mesh.obj;

import static org.assertj.core.api.Assertions.assertThat;

import dev.twister.mesh.Affine;
import dev.twister.mesh.MeshFile;
import dev.twister.mesh.MeshPart;
import dev.twister.mesh.Reading;
import dev.twister.mesh.TriangleMesh;
import dev.twister.scene.Material;
import dev.twister.scene.Rgb;
import dev.twister.scene.material.Emission;
import dev.twister.scene.material.Finish;
import dev.twister.scene.material.Maps;
import java.io.IOException;
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

class ObjReaderTest {
    private static final String SQUARE = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

    @TempDir
    Path folder;

    static Stream<Arguments> materials() {
        Rgb white = new Rgb(1, 1, 1);
        Rgb red = new Rgb(1, 0, 0);
        return Stream.of(
                Arguments.of("Kd 0.5 0.25 2", Material.DEFAULT.withColor(new Rgb(0.5, 0.25, 1))),
                Arguments.of("Kd 0.5", Material.DEFAULT.withColor(new Rgb(0.5, 0.5, 0.5))),
                Arguments.of(
                        "Kd 1 0 0\nKs 1 1 1\nNs 100",
                        Material.DEFAULT.withColor(red).withReflectivity(5)),
                Arguments.of("Kd 1 0 0\nKs 0.5 1 0\nNs 50\nillum 1", Material.DEFAULT.withColor(red)),
                Arguments.of("Ks 0.5 0.25 0\nillum 3", Material.DEFAULT.withReflectivity(64)),
                Arguments.of(
                        "Kd 0 0 0\nNi 1.33\nillum 7",
                        Material.DEFAULT.withColor(white).withTransmission(1).withIor(1.33)),
                Arguments.of(
                        "Kd 0 0 0\nTf 1 0 0\nd 0.25\nillum 4",
                        Material.DEFAULT.withColor(red).withTransmission(0.75)),
                Arguments.of(
                        "Kd 1 0 0\nTr 0.25",
                        Material.DEFAULT.withColor(red).withTransmission(0.25).withIor(1)),
                Arguments.of("Kd 1 0 0\nd 1\nTr 1", Material.DEFAULT.withColor(red)),
                Arguments.of("Kd 1 0 0\nTr 1.0", Material.DEFAULT.withColor(red)),
                Arguments.of("Ke 5 2 0", Material.DEFAULT.withEmission(Emission.NONE.withColor(new Rgb(5, 2, 0)))),
                Arguments.of("Pm 1\nPr 0.5", Material.DEFAULT.withMetallic(1).withRoughness(0.5)),
                Arguments.of(
                        "Pr 0.5\nPc 2\nPcr 0.25\nPs 0\naniso 0.75\nanisor 1.25",
                        Material.DEFAULT
                                .withRoughness(0.5)
                                .withFinish(Finish.NONE
                                        .withClearcoat(Finish.NONE
                                                .clearcoat()
                                                .withPart(1)
                                                .withRoughness(0.25))
                                        .withSheen(Finish.NONE.sheen().withRoughness(0.5))
                                        .withAnisotropy(Finish.NONE
                                                .anisotropy()
                                                .withStrength(0.75)
                                                .withRotation(Math.PI / 2)))),
                Arguments.of("Pr 0\nPc 0\nPs 0", Material.DEFAULT));
    }

    @ParameterizedTest(name = "{0}")
    @MethodSource("materials")
    void readsMaterials(String fields, Material expected) throws IOException {
        Files.writeString(folder.resolve("a b.mtl"), "newmtl other\nKd 0 1 0\nnewmtl m\n" + fields + "\n");
        MeshFile file = Reading.read(folder, "a.obj", "mtllib a b.mtl\nusemtl m\n" + SQUARE + "f 1 2 3\n");
        assertThat(file.parts()).containsExactly(new MeshPart("m", 0, Affine.IDENTITY, expected));
    }

    @Test
    void findsTexturesBesideTheFile() throws IOException {
        Files.createDirectory(folder.resolve("wood"));
        Files.write(folder.resolve("wood").resolve("oak 1.png"), new byte[] {(byte) 0x89, 'P', 'N', 'G', 13, 10});
        Files.writeString(
                folder.resolve("a.mtl"),
                "newmtl a\nmap_Kd -s 1 1 1 -clamp on wood\\oak 1.png\nnewmtl b\nmap_Kd none.png\n");
        List<String> warnings = new ArrayList<>();
        String text = "mtllib a.mtl\n" + SQUARE + "vt 0 0\nvt 1 0.25\nusemtl a\nf 1/1 2/2 3/2\nusemtl b\nf 1 3 4\n";
        MeshFile file = Reading.read(folder, "a.obj", text.getBytes(StandardCharsets.UTF_8), 0, warnings);
        assertThat(file.parts().get(0).material().texture()).contains(folder.resolve("wood/oak 1.png"));
        assertThat(file.parts().get(1).material().texture()).isEmpty();
        assertThat(file.meshes().get(0).textureCoordinates()).contains(1f, 0.75f);
        assertThat(file.meshes().get(1).textureCoordinates()).isEmpty();
        assertThat(warnings).anyMatch(warning -> warning.contains("'none.png': file not found"));
    }

    @Test
    void scalesAndMovesTextures() throws IOException {
        Files.write(folder.resolve("a.png"), new byte[] {(byte) 0x89, 'P', 'N', 'G', 13, 10});
        Files.writeString(folder.resolve("a.mtl"), "newmtl a\nmap_Kd -s 2 4 1 -o 0.5 0.25 a.png\nmap_Pr -t 1 a.png\n");
        List<String> warnings = new ArrayList<>();
        String text = "mtllib a.mtl\n" + SQUARE + "vt 1 0.5\nusemtl a\nf 1/1 2/1 3/1\n";
        MeshFile file = Reading.read(folder, "a.obj", text.getBytes(StandardCharsets.UTF_8), 0, warnings);
        Maps maps = file.parts().getFirst().material().maps();

        // From v upward, 4 * 0.5 + 0.25, to v downward.
        assertThat(file.meshes().getFirst().textureCoordinates())
                .containsExactly(1f, 0.5f, 1f, 0.5f, 1f, 0.5f, 2.5f, -1.25f, 2.5f, -1.25f, 2.5f, -1.25f);
        assertThat(maps.texture().coordinates()).isOne();
        assertThat(maps.roughness().orElseThrow().sampler().coordinates()).isZero();
        assertThat(warnings).anyMatch(warning -> warning.endsWith("the texture option '-t 1' is not read"));
    }

    @Test
    void makesAPartOfEachMaterial() {
        String text = SQUARE + "usemtl a\nf 1 2 3\nusemtl b\nf 1 3 4\nusemtl a\nf 2 3 4\n";
        MeshFile file = Reading.read(folder, "a.obj", text);
        assertThat(file.parts()).extracting(MeshPart::name).containsExactly("a", "b");
        assertThat(file.meshes()).extracting(TriangleMesh::triangles).containsExactly(2, 1);
    }

    @Test
    void countsDegenerateTriangles() {
        MeshFile file = Reading.read(folder, "a.obj", SQUARE + "v 0.5 0.5 0\nf 1 5 3\nf 1 1 2\nf 1 2 3 4\n");
        assertThat(file.degenerateTriangles()).isEqualTo(2);
        assertThat(file.meshes().getFirst().triangles()).isEqualTo(2);
    }

    @Test
    void givesCornersWithoutNormalsThatOfTheTriangle() {
        MeshFile file = Reading.read(folder, "a.obj", SQUARE + "vn 0 3 4\nvn nan 0 1\nf 1//1 2//2 3\n");
        assertThat(file.meshes().getFirst().normals()).containsExactly(0, 0.6f, -0.8f, 0, 0, -1, 0, 0, -1);
    }

    @Test
    void leavesOutNormalsThatAreNotThere() {
        MeshFile file = Reading.read(folder, "a.obj", SQUARE + "f 1/1/1 2/0/0 3/-1/-1\n");
        assertThat(file.meshes().getFirst().normals()).isEmpty();
        assertThat(file.meshes().getFirst().textureCoordinates()).isEmpty();
    }

    @Test
    void startsAfterAByteOrderMark() {
        assertThat(Reading.read(folder, "a.obj", "\ufeff" + SQUARE + "f 1 2 3\n")
                        .shownTriangles())
                .isEqualTo(1);
    }

    @Test
    void joinsLinesThatEndInABackslash() {
        assertThat(Reading.read(folder, "a.obj", "v 0 0 0\r\nv 1 \\\r\n 0 0\r\nv 0 1 0\r\nf 1 \\\r\n2 3 # end\r\n")
                        .shownTriangles())
                .isEqualTo(1);
    }

    /** Text is read through a buffer of 65,536 bytes, whose end lies before, in and behind each word of a line. */
    @Test
    void readsWordsOverTheEndOfTheBuffer() {
        for (int place = 0; place < 60; place++) {
            String start = "#" + " ".repeat(65_500 - SQUARE.length() + place) + "\n" + SQUARE;
            MeshFile file = Reading.read(folder, "a.obj", start + "usemtl red paint\nf 1 2 3\n");
            assertThat(file.parts()).extracting(MeshPart::name).containsExactly("red paint");
            assertThat(file.meshes().getFirst().positions()).containsExactly(0, 0, 0, 1, 1, 0, 1, 0, 0);
        }
    }

    @Test
    void sharesAVertexWhereCornersHaveEqualNormals() {
        String normals = "vn 0 0 1\nvn 0 1 0\nvn 1 0 0\n";
        String faces = "f 1//1 2//1 3//1\nf 1//2 3//1 4//1\nf 1//3 2//1 4//1\nf 1//2 2//1 3//2\n";
        TriangleMesh mesh =
                Reading.read(folder, "a.obj", SQUARE + normals + faces).meshes().getFirst();
        assertThat(mesh.corners()).containsExactly(0, 1, 2, 3, 4, 1, 5, 4, 2, 3, 6, 2);
        assertThat(mesh.positions()).hasSize(3 * 7);
    }
}
