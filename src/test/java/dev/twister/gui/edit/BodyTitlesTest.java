package dev.twister.gui.edit;

import static org.assertj.core.api.Assertions.assertThat;

import dev.twister.gui.bodies.BodyActions.BodyGroup;
import dev.twister.scene.Body;
import dev.twister.scene.Material;
import dev.twister.scene.Mesh;
import dev.twister.scene.Scene;
import dev.twister.scene.Sphere;
import dev.twister.scene.Vector3;
import dev.twister.world.SceneMeshes;
import java.nio.file.Path;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;

class BodyTitlesTest {
    private final Scene scene = Scenes.scene();

    @Test
    void bodiesAreListedInTheirOrder() {
        assertThat(BodyTitles.listed(scene, SelectedBodies.NONE))
                .containsExactly(BodyNumber.LIGHT, BodyNumber.PLANE, 2, 3);
        assertThat(BodyTitles.name(scene, 3)).isEqualTo("Sphere 2");
    }

    @Test
    void aCrowdIsNotListed() {
        Sphere sphere = scene.spheres().getFirst();
        Scene crowd = scene.withSpheres(Collections.nCopies(2000, sphere));

        assertThat(BodyTitles.listed(crowd, SelectedBodies.of(List.of(700, 30))))
                .containsExactly(BodyNumber.LIGHT, BodyNumber.PLANE, 30, 700);
    }

    @Test
    void aMeshIsListedByItsFileAndItsMaterial() {
        Mesh knot = Mesh.of(Path.of("some", "knot.obj"));
        Material glass = Material.DEFAULT.withTransmission(1);
        Scene meshes = scene.withMaterials(new LinkedHashMap<>(Map.of("glass", glass)))
                .withMeshes(List.of(knot, knot.withMaterial(glass)));
        int first = BodyNumber.ofMesh(0);

        assertThat(BodyTitles.listed(meshes, SelectedBodies.NONE)).endsWith(3, first, first + 1);
        assertThat(BodyTitles.name(meshes, first)).isEqualTo("Mesh 1 (knot.obj)");
        assertThat(BodyTitles.name(meshes, first + 1)).isEqualTo("Mesh 2 (knot.obj), glass");
    }

    @Test
    void theRoundGoesFromTheSpheresToTheMeshesAndToNothing() {
        Scene meshes = scene.withMeshes(List.of(Mesh.of(Path.of("knot.obj"))));

        assertThat(BodyEdits.along(meshes, 3, 1)).isEqualTo(BodyNumber.ofMesh(0));
        assertThat(BodyEdits.along(meshes, BodyNumber.ofMesh(0), 1)).isEqualTo(BodyNumber.NONE);
        assertThat(BodyEdits.along(meshes, BodyNumber.NONE, -1)).isEqualTo(BodyNumber.ofMesh(0));
        assertThat(BodyEdits.along(meshes, BodyNumber.ofMesh(0), -1)).isEqualTo(3);
    }

    @Test
    void aCopyStandsBesideItsOriginal() {
        Body sphere = BodyEdits.solid(scene, 2);
        double apart = BodyExtent.of(scene, SceneMeshes.NONE, 2).apart();

        Body copy = new BodyGroup(List.of(sphere), List.of(), apart)
                .beside()
                .bodies()
                .getFirst();

        assertThat(copy.position()).isEqualTo(new Vector3(3.3000000000000003, 2, 0));
        assertThat(copy.withPosition(sphere.position())).isEqualTo(sphere);
    }
}
