package dev.twister.gui.edit;

import static org.assertj.core.api.Assertions.assertThat;

import dev.twister.scene.CameraKeyframe;
import dev.twister.scene.Scene;
import java.util.List;
import org.junit.jupiter.api.Test;

class KeyframeEditsTest {
    private final Scene scene = Scenes.scene();

    private static List<Double> times(Scene scene) {
        return scene.camera().keyframes().stream().map(CameraKeyframe::seconds).toList();
    }

    private static Scene turned(Scene scene, double yaw) {
        return scene.withCamera(scene.camera().withYawDegrees(yaw));
    }

    @Test
    void keyframesAreInTheOrderOfTheirTimesAndOneTakesAnothersPlace() {
        Scene two = KeyframeEdits.set(KeyframeEdits.set(scene, 2.5), 1.004);
        assertThat(times(two)).containsExactly(1.0, 2.5);

        Scene changed = KeyframeEdits.set(turned(two, 10), 2.5);
        assertThat(times(changed)).containsExactly(1.0, 2.5);
        assertThat(changed.camera().keyframes().getLast())
                .isEqualTo(CameraKeyframe.of(2.5, turned(two, 10).camera()));
        assertThat(changed.camera().keyframes().getFirst())
                .isEqualTo(two.camera().keyframes().getFirst());
    }

    @Test
    void theCameraTurnsTheShortWay() {
        Scene first = KeyframeEdits.set(turned(scene, 170), 0);
        Scene second = KeyframeEdits.set(turned(first, -170), 1);
        Scene third = KeyframeEdits.set(turned(second, 160), 2);
        assertThat(third.camera().keyframes().stream()
                        .map(CameraKeyframe::yawDegrees)
                        .toList())
                .containsExactly(170.0, 190.0, 160.0);
    }

    @Test
    void aKeyframeStaysBetweenItsNeighboursWhereItIsMoved() {
        Scene three = KeyframeEdits.set(KeyframeEdits.set(KeyframeEdits.set(scene, 1), 2), 3);
        assertThat(times(KeyframeEdits.moved(three, 1, 2.4))).containsExactly(1.0, 2.4, 3.0);
        assertThat(times(KeyframeEdits.moved(three, 1, 9))).containsExactly(1.0, 2.99, 3.0);
        assertThat(times(KeyframeEdits.moved(three, 2, 9))).containsExactly(1.0, 2.0, 9.0);
        assertThat(times(KeyframeEdits.moved(three, 0, -4))).containsExactly(0.0, 2.0, 3.0);
    }

    @Test
    void aKeyframeIsFoundAtItsTimeAndDeleted() {
        Scene two = KeyframeEdits.set(KeyframeEdits.set(scene, 1), 2);
        assertThat(KeyframeEdits.at(two.camera().keyframes(), 2.003)).hasValue(1);
        assertThat(KeyframeEdits.at(two.camera().keyframes(), 1.5)).isEmpty();
        assertThat(times(KeyframeEdits.deleted(two, 0))).containsExactly(2.0);
    }

    @Test
    void aTypedTimeIsReadWithEitherPoint() {
        assertThat(KeyframeEdits.parse(" 2,5 ")).contains(2.5);
        assertThat(KeyframeEdits.parse("-1")).isEmpty();
        assertThat(KeyframeEdits.parse("soon")).isEmpty();
        assertThat(KeyframeEdits.text(10)).isEqualTo("10");
    }
}
