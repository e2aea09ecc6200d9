package dev.twister.mesh;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.data.Offset.offset;

import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Stream;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

/** Reads the same box from a file of each format. */
class SameShapeTest {
    @TempDir
    Path folder;

    static Stream<Arguments> files() {
        return Stream.of(
                Arguments.of("box.obj", MeshFiles.obj()),
                Arguments.of("text.ply", MeshFiles.plyText()),
                Arguments.of("little.ply", MeshFiles.ply(ByteOrder.LITTLE_ENDIAN)),
                Arguments.of("big.ply", MeshFiles.ply(ByteOrder.BIG_ENDIAN)),
                Arguments.of("text.stl", MeshFiles.stlText()),
                Arguments.of(
                        "upper.stl",
                        new String(MeshFiles.stlText(), StandardCharsets.US_ASCII)
                                .toUpperCase(Locale.ROOT)
                                .getBytes(StandardCharsets.US_ASCII)),
                Arguments.of("binary.stl", MeshFiles.stlBinary()),
                Arguments.of("box.gltf", MeshFiles.gltf()),
                Arguments.of("box.glb", MeshFiles.glb()));
    }

    @ParameterizedTest(name = "{0}")
    @MethodSource("files")
    void hasTheSameTriangles(String name, byte[] content) {
        Set<String> expected = new TreeSet<>();
        for (int[] triangle : MeshFiles.triangles()) {
            List<String> corners = new ArrayList<>();
            for (int corner : triangle) {
                float[] place = MeshFiles.CORNERS[corner];
                corners.add(Reading.place(place[0], place[1], place[2]));
            }
            expected.add(Reading.fromLeast(corners));
        }
        MeshFile file = Reading.read(folder, name, content, 0);
        assertThat(Reading.triangles(file)).isEqualTo(expected);
        assertThat(file.degenerateTriangles()).isZero();
    }

    @ParameterizedTest(name = "{0}")
    @MethodSource("files")
    void smoothsAcrossItsEdgesWhereAskedAlone(String name, byte[] content) {
        assertThat(Reading.read(folder, name, content, 0).meshes().getFirst().normals())
                .isEmpty();
        assertThat(Reading.read(folder, name, content, 80).meshes().getFirst().vertices())
                .isEqualTo(24);

        TriangleMesh round = Reading.read(folder, name, content, 95).meshes().getFirst();
        assertThat(round.vertices()).isEqualTo(8);
        float third = (float) Math.sqrt(1 / 3.0);
        for (int i = 0; i < round.normals().length; i++) {
            // The corners of a box are symmetric, however its sides are split.
            float outward = isLeast(round.positions(), i) ? -third : third;
            assertThat(round.normals()[i]).isCloseTo(outward, offset(1e-5f));
        }
    }

    private static boolean isLeast(float[] positions, int at) {
        for (int other = at % 3; other < positions.length; other += 3) {
            if (positions[other] < positions[at]) {
                return false;
            }
        }
        return true;
    }
}
