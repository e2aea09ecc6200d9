package dev.twister.mesh;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import dev.twister.scene.Geometry;
import dev.twister.scene.Material;
import dev.twister.scene.Scene;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class MeshStageTest {
    @TempDir
    private Path folder;

    @Test
    void scalesTheMeshToTwoMeters() {
        assertThat(stage("5").meshes().getFirst().scale()).isEqualTo(0.2);
    }

    @ParameterizedTest
    @ValueSource(strings = {"1e9", "1e-7"})
    void refusesAMeshThatCannotBeScaledSoFar(String half) {
        assertThatThrownBy(() -> stage(half))
                .isInstanceOf(MeshException.class)
                .hasMessageStartingWith(folder.resolve("a.obj") + ": the mesh is 2.0E")
                .hasMessageContaining(" m wide; expected 2.0E-6 to 2000000.0 m");
    }

    @Test
    void looksThroughBothWallsOfGlass() {
        MeshFile file = triangle("1");
        MeshPart part = file.parts().getFirst();
        Material glass = part.material().withTransmission(1);
        MeshFile vessel = new MeshFile(
                file.meshes(),
                List.of(part, new MeshPart(part.name(), part.mesh(), part.placement(), glass)),
                file.embeddedImages(),
                0);
        assertThat(stage(vessel).rendering().bounces()).isEqualTo(8);
        assertThat(stage(file).rendering().bounces()).isEqualTo(3);
    }

    private Scene stage(String half) {
        return stage(triangle(half));
    }

    private Scene stage(MeshFile file) {
        return MeshStage.of(new Geometry.OfFile(folder.resolve("a.obj")), file, Path.of("sky.hdr"), MeshPose.OF_FILE);
    }

    private MeshFile triangle(String half) {
        String text = "v -%1$s 0 0\nv %1$s 0 0\nv 0 %1$s 0\nf 1 2 3\n".formatted(half);
        return Reading.read(folder, "a.obj", text);
    }
}
