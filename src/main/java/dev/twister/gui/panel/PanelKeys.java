package dev.twister.gui.panel;

import javafx.event.ActionEvent;
import javafx.scene.Node;
import javafx.scene.Scene;
import javafx.scene.control.Slider;
import javafx.scene.control.TextField;
import javafx.scene.input.KeyCode;
import javafx.scene.input.KeyEvent;

/**
 * Keys that move the focus between picture and panel: Enter returns to the picture after a number is entered, and each
 * row has a key that leads to it.
 */
public final class PanelKeys {
    private PanelKeys() {}

    /**
     * Adds a filter to the window, which runs before its controls.
     *
     * @param show shows the panel
     */
    public static void install(Scene scene, Panel panel, Node picture, Runnable show) {
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
            panel.rowOf(event).ifPresent(row -> {
                show.run();
                panel.reveal(row);
                event.consume();
            });
        });
    }
}
