package dev.twister.gui.picking;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import dev.twister.gui.edit.Axis;
import dev.twister.gui.edit.Scenes;
import dev.twister.scene.Scene;
import dev.twister.scene.Vector3;
import java.util.List;
import org.junit.jupiter.api.Test;

class AxisHandleTest {
    private static final double LENGTH = 20;
    private final Scene scene = Scenes.scene();

    private static List<AxisHandle> handles(Scene scene, Vector3 middle) {
        return AxisHandle.of(Projection.of(Scenes.input(scene)), middle, LENGTH);
    }

    @Test
    void anAxisThatPointsAtTheViewerHasNoHandle() {
        assertThat(handles(scene, new Vector3(0, 2, 0)))
                .extracting(AxisHandle::axis)
                .containsExactly(Axis.X, Axis.Y);
        assertThat(handles(scene.withCamera(scene.camera().withYawDegrees(40)), new Vector3(4, 2, 0)))
                .extracting(AxisHandle::axis)
                .containsExactly(Axis.X, Axis.Y, Axis.Z);
    }

    @Test
    void handlesAreAsLongNearAsFar() {
        for (double z : new double[] {-5, 100}) {
            AxisHandle up = handles(scene, new Vector3(0, 2, z)).getLast();

            assertThat(up.middle().y() - up.tip().y()).isCloseTo(LENGTH, within(1e-6));
        }
    }

    @Test
    void theMiddleOfTheBodyIsFree() {
        AxisHandle up = handles(scene, new Vector3(0, 2, 0)).getLast();

        assertThat(up.distance(up.middle().x(), up.middle().y())).isCloseTo(LENGTH / 4, within(1e-6));
        assertThat(up.distance(up.tip().x() + 3, up.tip().y() + 5)).isCloseTo(3, within(1e-6));
    }

    @Test
    void behindTheCameraThereIsNone() {
        assertThat(handles(scene, new Vector3(0, 2, -20))).isEmpty();
    }
}
