package dev.twister.gui.controls;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import javafx.scene.input.KeyCodeCombination;
import javafx.scene.input.KeyCombination;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

class CommandTest {
    /** JavaFX takes a name that no key has for a character, which none types. */
    @ParameterizedTest
    @EnumSource
    void itsKeyIsOneThatKeyboardsHave(Command command) {
        assertThat(command.keys()).isInstanceOf(KeyCodeCombination.class);
    }

    @Test
    void noTwoHaveTheSameKeys() {
        assertThat(Arrays.stream(Command.values()).map(Command::keys).map(KeyCombination::getName))
                .doesNotHaveDuplicates();
    }
}
