package dev.twister.gui.controls;

import javafx.scene.control.TextField;
import javafx.scene.control.skin.TextFieldSkin;

/**
 * Stops the caret of a text field without the focus. JavaFX starts its blinking whenever a text is set, and then asks
 * for 60 pulses per second for as long as the program runs.
 */
public final class StillCaret {
    private StillCaret() {}

    public static void install(TextField field) {
        // After the skin's own listener, which starts it.
        field.skinProperty().subscribe(skin -> {
            if (skin instanceof TextFieldSkin drawn) {
                field.caretPositionProperty().subscribe(_ -> stop(field, drawn));
            }
        });
    }

    private static void stop(TextField field, TextFieldSkin skin) {
        if (!field.isFocused()) {
            skin.setCaretAnimating(false);
        }
    }
}
