package dev.twister.gui.studio;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import dev.twister.gui.edit.Scenes;
import dev.twister.gui.picking.Projection;
import dev.twister.scene.Camera;
import dev.twister.scene.Vector3;
import org.junit.jupiter.api.Test;

class OrbitTest {
    private static final Vector3 PIVOT = new Vector3(3, 1, 4);
    private final Camera camera = Camera.of(new Vector3(0, 2, -10), 20, 10, 60);

    @Test
    void thePivotStaysWhereItIsInThePicture() {
        Camera turned = Orbit.turned(camera, PIVOT, 50, -25);

        assertThat(turned.yawDegrees()).isCloseTo(70, within(1e-9));
        assertThat(place(turned)).containsExactly(place(camera), within(1e-2));
        assertThat(distance(turned)).isCloseTo(distance(camera), within(1e-9));
    }

    @Test
    void aDollyChangesTheDistanceAlone() {
        assertThat(distance(Orbit.dollied(camera, PIVOT, 0.5))).isCloseTo(distance(camera) / 2, within(1e-9));
        assertThat(distance(Orbit.dollied(camera, PIVOT, 1e-9))).isCloseTo(0.05, within(1e-9));
    }

    @Test
    void aPanMovesAcrossTheView() {
        Camera straight = Camera.of(new Vector3(0, 2, -10), 0, 0, 60);

        assertThat(Orbit.panned(straight, 2, 1).position()).isEqualTo(new Vector3(2, 3, -10));
    }

    @Test
    void aFramedBodyIsInTheMiddle() {
        Camera framed = Orbit.framed(camera, PIVOT, 1);

        assertThat(place(framed)).containsExactly(new double[] {Scenes.WIDTH / 2.0, Scenes.HEIGHT / 2.0}, within(1e-2));
        assertThat(distance(framed)).isCloseTo(2.8, within(1e-9));
    }

    private static double[] place(Camera seenFrom) {
        return Projection.of(Scenes.input(Scenes.scene().withCamera(seenFrom))).point(PIVOT);
    }

    private static double distance(Camera from) {
        Vector3 place = from.position();
        return Math.hypot(Math.hypot(place.x() - PIVOT.x(), place.y() - PIVOT.y()), place.z() - PIVOT.z());
    }
}
