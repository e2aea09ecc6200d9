package dev.twister.gui;

import javafx.scene.Scene;
import javafx.scene.input.KeyCode;
import javafx.scene.input.KeyEvent;
import javafx.scene.input.MouseEvent;
import javafx.scene.input.ScrollEvent;

/** Keeps an Alt that was held for the mouse from leading to the menu when it is let go. */
final class AltKey {
    private boolean usedByMouse;

    private AltKey() {}

    static void install(Scene scene) {
        AltKey alt = new AltKey();
        scene.addEventFilter(MouseEvent.MOUSE_PRESSED, event -> alt.usedByMouse |= event.isAltDown());
        scene.addEventFilter(ScrollEvent.SCROLL, event -> alt.usedByMouse |= event.isAltDown());
        scene.addEventFilter(KeyEvent.KEY_PRESSED, _ -> alt.usedByMouse = false);
        scene.addEventFilter(KeyEvent.KEY_RELEASED, event -> {
            if (event.getCode() == KeyCode.ALT && alt.usedByMouse) {
                event.consume();
            }
        });
    }
}
