package dev.twister.gui.picking;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import dev.twister.gui.edit.Axis;
import dev.twister.gui.edit.BodyEdits;
import dev.twister.gui.edit.BodyTransform;
import dev.twister.gui.edit.Scenes;
import dev.twister.gui.edit.SelectedBodies;
import dev.twister.scene.Scene;
import dev.twister.scene.Vector3;
import dev.twister.world.FrameInput;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

class RotationRingTest {
    private static final double RADIUS = 20;
    private static final Vector3 MIDDLE = new Vector3(0, 2, 0);
    private final Scene scene = Scenes.scene();

    private static List<RotationRing> rings(Scene scene, Vector3 middle) {
        return RotationRing.of(Projection.of(Scenes.input(scene)), middle, RADIUS);
    }

    @Test
    void aRingSeenEdgeOnIsNone() {
        assertThat(rings(scene, MIDDLE)).extracting(RotationRing::axis).containsExactly(Axis.Z);
    }

    @Test
    void aRingThatFacesTheCameraIsACircle() {
        RotationRing ring = rings(scene, MIDDLE).getFirst();

        assertThat(ring.points().getFirst().distance(ring.points().getLast())).isCloseTo(0, within(1e-6));
        assertThat(ring.distance(Scenes.WIDTH / 2.0, Scenes.HEIGHT / 2.0)).isCloseTo(RADIUS, within(0.1));
        assertThat(ring.distance(Scenes.WIDTH / 2.0 + RADIUS + 3, Scenes.HEIGHT / 2.0))
                .isCloseTo(3, within(0.1));
    }

    @Test
    void ofAnotherRingTheHalfNearTheCameraIsShown() {
        Scene turned = scene.withCamera(scene.camera().withPosition(new Vector3(-8, 8, -10)));
        RotationRing about = rings(turned, MIDDLE).stream()
                .filter(ring -> ring.axis() == Axis.Y)
                .findFirst()
                .orElseThrow();

        assertThat(about.points().getFirst().distance(about.points().getLast())).isGreaterThan(RADIUS);
    }

    @Test
    void behindTheCameraThereIsNone() {
        assertThat(rings(scene, new Vector3(0, 2, -20))).isEmpty();
    }

    @ParameterizedTest
    @EnumSource(Axis.class)
    void degreesGrowAsABodyIsRotated(Axis axis) {
        Scene above = scene.withCamera(scene.camera()
                .withPosition(new Vector3(-8, 8, -10))
                .withPitchDegrees(25)
                .withYawDegrees(35));
        FrameInput input = Scenes.input(above);
        BodyTransform small =
                BodyTransform.of(above, SelectedBodies.of(3)).orElseThrow().about(MIDDLE);
        Scene rotated = small.rotated(above, axis.from(Vector3.ZERO, 1), 30);

        double before = degrees(input, axis, BodyEdits.position(above, 3));
        double after = degrees(input, axis, BodyEdits.position(rotated, 3));
        assertThat((after - before + 360) % 360).isCloseTo(30, within(1e-2));
    }

    /** Of a place beside the pivot, where the plane across the axis through it is met. */
    private static double degrees(FrameInput input, Axis axis, Vector3 place) {
        double[] seen = Projection.of(input).point(place);
        Vector3 pivot = axis.with(MIDDLE, axis.of(place));
        return RotationRing.degrees(input, axis, pivot, seen[0], seen[1]).orElseThrow();
    }
}
