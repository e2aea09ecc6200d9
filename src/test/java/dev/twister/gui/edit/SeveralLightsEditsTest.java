package dev.twister.gui.edit;

import static org.assertj.core.api.Assertions.assertThat;

import dev.twister.gui.picking.PointerRay;
import dev.twister.gui.property.NumberProperty;
import dev.twister.gui.property.PanelNumbers;
import dev.twister.mesh.MeshFile;
import dev.twister.oracle.MeshShapes;
import dev.twister.scene.Light;
import dev.twister.scene.Mesh;
import dev.twister.scene.Rgb;
import dev.twister.scene.Scene;
import dev.twister.scene.Vector3;
import dev.twister.world.FrameInput;
import dev.twister.world.LightStrength;
import dev.twister.world.SceneImages;
import dev.twister.world.SceneMeshes;
import dev.twister.world.World;
import java.nio.file.Path;
import java.util.List;
import java.util.Set;
import org.junit.jupiter.api.Test;

/** Lights as bodies of the window: a scene of three lights, two spheres and a mesh. */
class SeveralLightsEditsTest {
    private static final int SECOND = BodyNumber.ofLight(1);
    private static final int THIRD = BodyNumber.ofLight(2);
    private static final Light RED = Light.of(new Vector3(1, 5, 0), 0.5, new Rgb(1, 0, 0));
    private static final Light BLUE = Light.of(new Vector3(3, 4, -4), 0.5, new Rgb(0, 0, 1));

    private final Scene one = Scenes.scene().withMeshes(List.of(Mesh.of(Path.of("ball.obj"))));
    private final Scene scene = one.withLights(one.lights().with(List.of(RED, BLUE)));

    @Test
    void lightsAreListedFirst() {
        assertThat(BodyTitles.listed(scene, SelectedBodies.NONE))
                .containsExactly(BodyNumber.LIGHT, SECOND, THIRD, BodyNumber.PLANE, 2, 3, BodyNumber.ofMesh(0));
        assertThat(BodyTitles.name(scene, BodyNumber.LIGHT)).isEqualTo("Light 1");
        assertThat(BodyTitles.name(scene, THIRD)).isEqualTo("Light 3");
    }

    @Test
    void theRoundVisitsEveryBodyOnce() {
        int body = BodyNumber.NONE;
        for (int expected : BodyTitles.listed(scene, SelectedBodies.NONE)) {
            assertThat(BodyEdits.along(scene, expected, -1)).isEqualTo(body);
            body = BodyEdits.along(scene, body, 1);
            assertThat(body).isEqualTo(expected);
        }
        assertThat(BodyEdits.along(scene, body, 1)).isEqualTo(BodyNumber.NONE);
    }

    @Test
    void oneIsMovedAlone() {
        Scene moved = BodyEdits.moved(scene, SECOND, new Vector3(7, 8, 9));

        assertThat(moved).isEqualTo(BodyEdits.withLight(scene, SECOND, RED.withPosition(new Vector3(7, 8, 9))));
        assertThat(BodyEdits.position(moved, SECOND)).isEqualTo(new Vector3(7, 8, 9));
        assertThat(moved.lights().get(2)).isEqualTo(BLUE);
    }

    @Test
    void deletingTheFirstMakesTheSecondTheFirst() {
        Scene rest = BodyEdits.deleted(scene, BodyNumber.LIGHT);

        assertThat(rest.lights().list()).containsExactly(RED, BLUE);
        assertThat(rest.spheres()).isEqualTo(scene.spheres());
    }

    @Test
    void oneLightIsNeverDeleted() {
        SelectedBodies all = SelectedBodies.of(BodyEdits.movable(scene));

        SelectedBodies deletable = BodyEdits.deletable(scene, all);
        assertThat(deletable.bodies()).containsExactly(SECOND, THIRD, 2, 3, BodyNumber.ofMesh(0));
        assertThat(BodyEdits.deleted(scene, deletable.bodies()).lights()).isEqualTo(one.lights());
        assertThat(BodyEdits.deletable(one, SelectedBodies.of(BodyNumber.LIGHT)).count())
                .isZero();
        assertThat(BodyEdits.deletable(scene, SelectedBodies.of(List.of(BodyNumber.LIGHT, THIRD)))
                        .count())
                .isEqualTo(2);
    }

    @Test
    void numbersOfOneChangeItAlone() {
        NumberProperty<Scene> height = PanelNumbers.ofLight(2).get(1);

        assertThat(height.read(scene)).isEqualTo(4);
        assertThat(height.write(scene, 6).lights().list())
                .containsExactly(one.lights().first(), RED, BLUE.withPosition(new Vector3(3, 6, -4)));
    }

    @Test
    void aLightWithoutStrengthShowsTheUsualOneAndGoesBackToIt() {
        NumberProperty<Scene> strength = number("Light strength");
        assertThat(strength.read(scene)).isEqualTo(LightStrength.usual(RED, scene.ground()));

        Scene stated = strength.write(scene, 12);
        assertThat(stated.lights().get(1)).isEqualTo(RED.withStrength(12.0));
        assertThat(strength.write(stated, strength.read(scene))).isEqualTo(scene);
    }

    @Test
    void theShareOfOneLightIsWritten() {
        assertThat(number("Light share").write(scene, 0.5).lights().get(1)).isEqualTo(RED.withShare(0.5));
    }

    private static NumberProperty<Scene> number(String label) {
        return PanelNumbers.ofLight(1, label);
    }

    @Test
    void picturesNumberThemBetweenSpheresAndMeshes() {
        MeshFile ball = MeshShapes.file(MeshShapes.icosphere(0));
        SceneMeshes meshes = SceneMeshes.of(scene, _ -> ball);
        FrameInput input = World.of(scene, SceneImages.of(Scenes.SKY), meshes).snapshot();

        assertThat(List.of(
                        BodyNumber.inScene(0, input, scene, meshes),
                        BodyNumber.inScene(3, input, scene, meshes),
                        BodyNumber.inScene(4, input, scene, meshes),
                        BodyNumber.inScene(5, input, scene, meshes),
                        BodyNumber.inScene(6, input, scene, meshes)))
                .containsExactly(BodyNumber.LIGHT, 3, SECOND, THIRD, BodyNumber.ofMesh(0));
        assertThat(Set.of(input.light(1), input.light(2))).isEqualTo(Set.of(4, 5));
    }

    @Test
    void pickedWhereTheyAreSeen() {
        Scene near = scene.withLights(
                scene.lights().with(1, RED.withPosition(new Vector3(0, 2, -5)).withRadius(1)));
        FrameInput input = World.of(near.withMeshes(List.of()), Scenes.SKY).snapshot();

        int body = PointerRay.bodyAt(input, Scenes.WIDTH / 2.0, Scenes.HEIGHT / 2.0);
        assertThat(BodyNumber.inScene(body, input, near, SceneMeshes.NONE)).isEqualTo(SECOND);
    }
}
