package dev.twister.world.table;

import static org.assertj.core.api.Assertions.assertThat;

import dev.twister.mesh.Affine;
import dev.twister.mesh.MeshFile;
import dev.twister.mesh.MeshPart;
import dev.twister.mesh.TriangleMesh;
import dev.twister.oracle.MeshShapes;
import dev.twister.scene.Material;
import dev.twister.scene.Vector3;
import java.util.List;
import org.junit.jupiter.api.Test;

class FarPointsTest {
    @Test
    void aCubesAreItsCorners() {
        TriangleMesh cube = MeshShapes.cube();

        List<Vector3> points = FarPoints.of(MeshShapes.file(cube));

        assertThat(points).hasSize(8);
        assertThat(points).allMatch(point -> contains(cube.positions(), point));
    }

    @Test
    void partsAreWhereTheFileHasThem() {
        Affine right =
                new Affine(new Vector3(1, 0, 0), new Vector3(0, 1, 0), new Vector3(0, 0, 1), new Vector3(10, 0, 0));
        MeshFile file = MeshShapes.file(
                List.of(MeshShapes.cube()),
                List.of(
                        new MeshPart("", 0, Affine.IDENTITY, Material.DEFAULT),
                        new MeshPart("", 0, right, Material.DEFAULT)));

        List<Vector3> points = FarPoints.of(file);

        double least = points.stream().mapToDouble(Vector3::x).min().orElseThrow();
        double largest = points.stream().mapToDouble(Vector3::x).max().orElseThrow();
        assertThat(least).isEqualTo(file.bounds().least().x());
        assertThat(largest).isEqualTo(file.bounds().largest().x());
    }

    private static boolean contains(float[] positions, Vector3 point) {
        for (int at = 0; at < positions.length; at += 3) {
            if (positions[at] == point.x() && positions[at + 1] == point.y() && positions[at + 2] == point.z()) {
                return true;
            }
        }
        return false;
    }
}
