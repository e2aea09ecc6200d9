package dev.twister.gui.edit;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import dev.twister.gui.bodies.BoxSelection;
import dev.twister.gui.picture.SafeFrame.FrameOutline;
import dev.twister.scene.Camera;
import dev.twister.scene.Mesh;
import dev.twister.scene.Rotation;
import dev.twister.scene.Scene;
import dev.twister.scene.Shape;
import dev.twister.scene.Vector3;
import java.util.List;
import org.junit.jupiter.api.Test;

class BodyTransformTest {
    private static final Vector3 UP = new Vector3(0, 1, 0);
    private static final Scene SCENE = Scenes.scene()
            .withMeshes(List.of(Mesh.of(Shape.of(Shape.Kind.BOX, 1)).withRotation(new Rotation(20, 10, 30))));
    private static final int BALL = BodyNumber.ofSphere(0);
    private static final int OTHER = BodyNumber.ofSphere(1);
    private static final int BOX = BodyNumber.ofMesh(0);

    private static BodyTransform of(Integer... bodies) {
        return BodyTransform.of(SCENE, SelectedBodies.of(List.of(bodies))).orElseThrow();
    }

    @Test
    void bodiesMoveTogether() {
        Scene moved = of(BALL, BodyNumber.LIGHT).moved(SCENE, new Vector3(1, 0, -2));

        assertThat(BodyEdits.position(moved, BALL)).isEqualTo(new Vector3(1, 2, -2));
        assertThat(BodyEdits.position(moved, BodyNumber.LIGHT)).isEqualTo(new Vector3(-3, 6, -2));
    }

    @Test
    void bodiesTurnAboutTheirMiddle() {
        // At (0, 2, 0) and (4, 2, 2).
        Scene turned = of(BALL, OTHER).rotated(SCENE, UP, 180);

        assertThat(BodyEdits.position(turned, BALL).minus(new Vector3(4, 2, 2)).length())
                .isLessThan(1e-9);
    }

    @Test
    void aTurnAboutTheUprightAxisIsAddedToTheYaw() {
        assertThat(BodyEdits.mesh(of(BOX).rotated(SCENE, UP, 25), BOX).rotation())
                .isEqualTo(new Rotation(45, 10, 30));
    }

    @Test
    void turningThereAndBackLeavesTheAngles() {
        Vector3 askew = new Vector3(1, 2, 3).normalized();
        Scene there = of(BOX).rotated(SCENE, askew, 100);
        Scene back =
                BodyTransform.of(there, SelectedBodies.of(BOX)).orElseThrow().rotated(there, askew, -100);

        Rotation rotation = BodyEdits.mesh(back, BOX).rotation();
        assertThat(rotation.yawDegrees()).isCloseTo(20, within(1e-4));
        assertThat(rotation.pitchDegrees()).isCloseTo(10, within(1e-4));
        assertThat(rotation.rollDegrees()).isCloseTo(30, within(1e-4));
    }

    @Test
    void scalingEnlargesBodiesAndTheirDistances() {
        Scene scaled = of(BALL, OTHER).scaled(SCENE, 2);

        assertThat(BodyEdits.sphere(scaled, BALL).radius()).isEqualTo(3);
        assertThat(BodyEdits.position(scaled, OTHER)
                        .minus(BodyEdits.position(scaled, BALL))
                        .length())
                .isCloseTo(2 * new Vector3(4, 0, 2).length(), within(1e-9));
    }

    @Test
    void everyChangeBeginsFromTheStart() {
        BodyTransform bodies = of(BALL, BOX);
        Scene much = bodies.scaled(bodies.rotated(SCENE, UP, 77), 3);

        assertThat(bodies.moved(much, Vector3.ZERO)).isEqualTo(SCENE);
    }

    @Test
    void aBoxSelectsWhatHasItsMiddleInIt() {
        List<Integer> inside = BoxSelection.Box.between(
                        Scenes.WIDTH / 2.0 + 5,
                        Scenes.HEIGHT / 2.0 + 5,
                        Scenes.WIDTH / 2.0 - 5,
                        Scenes.HEIGHT / 2.0 - 5)
                .bodies(Scenes.scene(), Scenes.input(Scenes.scene()), body -> BodyEdits.position(Scenes.scene(), body));

        assertThat(inside).containsExactly(BALL);
    }

    @Test
    void aWideFrameIsAsHighAsAWindowThatIsLessWide() {
        assertThat(FrameOutline.of(400, 300, 1920, 1080, Camera.Projection.PERSPECTIVE))
                .isEqualTo(new FrameOutline(300 / 1080.0 * 1920, 300 / 1080.0 * 1080));
    }

    @Test
    void aFrameWithoutPerspectiveIsAsHighAsTheWindowAndAPanoramaFillsIt() {
        assertThat(FrameOutline.of(300, 400, 100, 50, Camera.Projection.ORTHOGRAPHIC))
                .isEqualTo(new FrameOutline(800, 400));
        assertThat(FrameOutline.of(300, 400, 100, 50, Camera.Projection.PANORAMA))
                .isEqualTo(new FrameOutline(300, 400));
    }
}
