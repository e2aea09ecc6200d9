package dev.twister.gui.camera;

import static org.assertj.core.api.Assertions.assertThat;

import dev.twister.gui.camera.CameraKeys.HeldKeys;
import dev.twister.world.animation.Turn;
import dev.twister.world.animation.Walk;
import javafx.scene.input.KeyCode;
import org.junit.jupiter.api.Test;

class HeldKeysTest {
    private final HeldKeys keys = new HeldKeys();

    @Test
    void heldKeysAddUp() {
        keys.press(KeyCode.W);
        keys.press(KeyCode.A);
        keys.press(KeyCode.E);
        keys.press(KeyCode.SHIFT);

        assertThat(keys.walk()).isEqualTo(new Walk(-1, 1, 1, true));
    }

    @Test
    void aRepeatedPressIsOne() {
        keys.press(KeyCode.D);
        keys.press(KeyCode.D);
        keys.release(KeyCode.D);

        assertThat(keys.walk()).isEqualTo(Walk.STILL);
    }

    @Test
    void oppositesCancel() {
        keys.press(KeyCode.S);
        keys.press(KeyCode.W);
        keys.press(KeyCode.Q);

        assertThat(keys.walk()).isEqualTo(new Walk(0, -1, 0, false));
        keys.setQUp(true);
        assertThat(keys.walk()).isEqualTo(new Walk(0, 1, 0, false));
    }

    @Test
    void arrowsTurn() {
        keys.press(KeyCode.LEFT);
        keys.press(KeyCode.DOWN);
        assertThat(keys.turn()).isEqualTo(new Turn(-1, 1, false));

        keys.press(KeyCode.RIGHT);
        keys.press(KeyCode.SHIFT);
        assertThat(keys.turn()).isEqualTo(new Turn(0, 1, true));

        keys.releaseAll();
        assertThat(keys.turn()).isEqualTo(Turn.STILL);
    }

    @Test
    void otherKeysAreLeftAlone() {
        assertThat(keys.press(KeyCode.X)).isFalse();
        assertThat(keys.walk().isStill()).isTrue();
    }
}
