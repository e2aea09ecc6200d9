package dev.twister.mesh;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import dev.twister.scene.Vector3;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Meshes far from their file's origin, as surveys place them. */
class FarMeshesTest {
    @TempDir
    Path folder;

    private static Vector3 placed(MeshFile file, int vertex) {
        MeshPart part = file.parts().getFirst();
        float[] positions = file.meshes().get(part.mesh()).positions();
        return part.placement()
                .point(new Vector3(positions[3 * vertex], positions[3 * vertex + 1], positions[3 * vertex + 2]));
    }

    @Test
    void keepMillimetersAtTheCoordinatesOfASurvey() {
        MeshFile file = Reading.read(
                folder,
                "a.obj",
                "v 445000.001 5000000.002 10.003\nv 445001.5 5000000.5 10\nv 445000.25 5000001.75 11\nf 1 2 3\n");

        assertThat(placed(file, 0).x()).isCloseTo(445000.001, within(1e-6));
        assertThat(placed(file, 0).y()).isCloseTo(5000000.002, within(1e-6));
        assertThat(placed(file, 0).z()).isCloseTo(-10.003, within(1e-6));
        assertThat(file.meshes().getFirst().positions()[0]).isBetween(-2f, 2f);
    }

    @Test
    void keepTrianglesThatFloatsAtTheOriginWouldCollapse() {
        MeshFile file = Reading.read(
                folder, "a.obj", "v 445000 0 0\nv 445000.001 0 0\nv 445000 0.001 0\nv 445001 0 0\nf 1 2 3\nf 1 4 3\n");

        assertThat(file.degenerateTriangles()).isZero();
    }

    @Test
    void keepTheirCoordinatesNearTheOrigin() {
        MeshFile file = Reading.read(folder, "a.obj", "v 1 0 0\nv 3 0 0\nv 1 1 0\nf 1 2 3\n");

        assertThat(file.parts().getFirst().placement()).isEqualTo(Affine.IDENTITY);
    }

    @Test
    void keepTheirPlaceInStlFiles() {
        MeshFile file = Reading.read(folder, "a.stl", """
                solid
                facet normal 0 0 1
                outer loop
                vertex 445000.001 0 7
                vertex 445001 0 7
                vertex 445000 1 7
                endloop
                endfacet
                endsolid
                """);

        assertThat(file.bounds().least().x()).isCloseTo(445000, within(1e-6));
        assertThat(file.bounds().largest().y()).isCloseTo(7, within(1e-6));
        assertThat(file.bounds().largest().z()).isCloseTo(1, within(1e-6));
    }
}
