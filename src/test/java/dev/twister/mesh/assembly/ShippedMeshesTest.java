package dev.twister.mesh.assembly;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.data.Offset.offset;

import dev.twister.mesh.MeshFile;
import dev.twister.mesh.MeshReader;
import dev.twister.mesh.TriangleMesh;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** The meshes in scenes/meshes must be closed bodies whose triangles face outward. */
class ShippedMeshesTest {
    @ParameterizedTest(name = "{0}")
    @CsvSource({
        "knot.obj, 6336, 6.444",
        "bowl.ply, 5120, 0.352",
        "vase.obj, 720, 0.2508",
        "vase.glb, 720, 0.2508",
        "vase.ply, 720, 0.2508",
        "vase.stl, 720, 0.2508"
    })
    void areClosed(String name, long triangles, double volume) {
        List<String> warnings = new ArrayList<>();
        MeshFile file = MeshReader.read(Path.of("scenes", "meshes", name), 0, warnings::add);
        assertThat(warnings).isEmpty();
        assertThat(file.degenerateTriangles()).isZero();
        assertThat(file.shownTriangles()).isEqualTo(triangles);
        double sum = 0;
        for (TriangleMesh mesh : file.meshes()) {
            assertClosed(mesh);
            sum += volume(mesh);
        }
        assertThat(sum).isCloseTo(volume, offset(0.01 * volume));
    }

    /** Each edge belongs to one triangle in each direction; only positions are compared. */
    private static void assertClosed(TriangleMesh mesh) {
        PositionIndex index = new PositionIndex(new DoubleList());
        Map<Long, Integer> balances = new HashMap<>();
        for (int i = 0; i < mesh.corners().length; i++) {
            int from = place(mesh, i, index);
            int to = place(mesh, i % 3 == 2 ? i - 2 : i + 1, index);
            balances.merge((long) Math.min(from, to) << 32 | Math.max(from, to), from < to ? 1 : -1, Integer::sum);
        }
        assertThat(balances.values()).containsOnly(0);
    }

    private static int place(TriangleMesh mesh, int corner, PositionIndex index) {
        int at = 3 * mesh.corners()[corner];
        return index.of(mesh.positions()[at], mesh.positions()[at + 1], mesh.positions()[at + 2]);
    }

    /** Computes the volume by the divergence theorem. */
    private static double volume(TriangleMesh mesh) {
        double sum = 0;
        float[] p = mesh.positions();
        for (int i = 0; i < mesh.corners().length; i += 3) {
            int a = 3 * mesh.corners()[i];
            int b = 3 * mesh.corners()[i + 1];
            int c = 3 * mesh.corners()[i + 2];
            sum += p[a] * ((double) p[b + 1] * p[c + 2] - (double) p[b + 2] * p[c + 1])
                    + p[a + 1] * ((double) p[b + 2] * p[c] - (double) p[b] * p[c + 2])
                    + p[a + 2] * ((double) p[b] * p[c + 1] - (double) p[b + 1] * p[c]);
        }
        return sum / 6;
    }
}
