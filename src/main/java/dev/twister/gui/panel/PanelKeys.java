package dev.twister.gui.panel;

import java.util.function.Consumer;
import javafx.event.ActionEvent;
import javafx.scene.Node;
import javafx.scene.Scene;
import javafx.scene.control.Slider;
import javafx.scene.control.TextField;
import javafx.scene.input.KeyCode;
import javafx.scene.input.KeyEvent;

/**
 * Keys that move the focus between picture and panel: Enter returns to the picture after a number is entered; in the
 * picture, Tab shows and hides the panel.
 */
public final class PanelKeys {
    private PanelKeys() {}

    /**
     * Adds a filter to the window, which runs before its controls.
     *
     * @param setShown shows or hides the panel
     */
    public static void install(Scene scene, Panel panel, Node picture, Consumer<Boolean> setShown) {
        panel.addEventHandler(ActionEvent.ACTION, event -> {
            if (event.getTarget() instanceof TextField field && panel.isTaken(field)) {
                picture.requestFocus();
            }
        });
        panel.addEventHandler(KeyEvent.KEY_PRESSED, event -> {
            if (event.getCode() == KeyCode.ENTER && event.getTarget() instanceof Slider) {
                picture.requestFocus();
                event.consume();
            }
        });
        scene.addEventFilter(KeyEvent.KEY_PRESSED, event -> {
            if (event.getCode() == KeyCode.TAB && !event.isControlDown() && !event.isAltDown()) {
                if (picture.isFocused() || scene.getFocusOwner() == null) {
                    setShown.accept(!panel.isVisible());
                    event.consume();
                }
            } else {
                panel.rowOf(event).ifPresent(row -> {
                    setShown.accept(true);
                    panel.reveal(row);
                    event.consume();
                });
            }
        });
    }
}
