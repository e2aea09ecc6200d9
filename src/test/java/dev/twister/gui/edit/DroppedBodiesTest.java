package dev.twister.gui.edit;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import dev.twister.mesh.MeshFile;
import dev.twister.oracle.MeshShapes;
import dev.twister.scene.Mesh;
import dev.twister.scene.Rgb;
import dev.twister.scene.Scene;
import dev.twister.scene.Sphere;
import dev.twister.scene.Vector3;
import dev.twister.world.SceneMeshes;
import java.nio.file.Path;
import java.util.List;
import java.util.Set;
import org.junit.jupiter.api.Test;

class DroppedBodiesTest {
    private static final int SPHERE = BodyNumber.ofSphere(0);
    private static final int MESH = BodyNumber.ofMesh(0);

    private final Scene scene = Scenes.scene()
            .withSpheres(List.of(Sphere.of(new Vector3(1, 7, 2), 0.5, new Rgb(1, 0, 0), 0)))
            .withMeshes(List.of(Mesh.of(Path.of("ball.obj"))
                    .withPosition(new Vector3(3, 9, 4))
                    .withScale(2)));
    private final MeshFile ball = MeshShapes.file(MeshShapes.icosphere(2));

    @Test
    void aSphereStandsOnTheGround() {
        Scene raised = scene.withGround(scene.ground().withHeight(-1));
        Scene dropped = BodyEdits.onGround(raised, SceneMeshes.NONE, Set.of(SPHERE));

        assertThat(BodyEdits.position(dropped, SPHERE)).isEqualTo(new Vector3(1, -0.5, 2));
    }

    @Test
    void aMeshStandsOnItsLowestPoint() {
        SceneMeshes meshes = SceneMeshes.of(scene, _ -> ball);
        Scene dropped = BodyEdits.onGround(scene, meshes, Set.of(MESH));

        assertThat(meshes.farPoints(BodyEdits.mesh(dropped, MESH)).stream()
                        .mapToDouble(Vector3::y)
                        .min()
                        .orElseThrow())
                .isCloseTo(0, within(1e-6));
        assertThat(BodyEdits.position(dropped, MESH).x()).isEqualTo(3);
    }

    @Test
    void aMeshThatIsNotReadAndALightStay() {
        assertThat(BodyEdits.onGround(scene, SceneMeshes.NONE, Set.of(MESH, BodyNumber.LIGHT)))
                .isEqualTo(scene);
    }
}
