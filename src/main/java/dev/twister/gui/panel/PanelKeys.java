package dev.twister.gui.panel;

import javafx.event.ActionEvent;
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
     * Lets Enter lead back to the picture.
     *
     * @param toPicture gives the picture the focus
     */
    public static void leadBack(Panel panel, Runnable toPicture) {
        panel.addEventHandler(ActionEvent.ACTION, event -> {
            if (event.getTarget() instanceof TextField field && panel.isTaken(field)) {
                toPicture.run();
            }
        });
        panel.addEventHandler(KeyEvent.KEY_PRESSED, event -> {
            if (event.getCode() == KeyCode.ENTER && event.getTarget() instanceof Slider) {
                toPicture.run();
                event.consume();
            }
        });
    }

    /**
     * Adds a filter to a window, which runs before its controls.
     *
     * @param show shows the panel
     */
    public static void install(Scene scene, Panel panel, Runnable show) {
        scene.addEventFilter(KeyEvent.KEY_PRESSED, event -> {
            panel.rowOf(event).ifPresent(row -> {
                show.run();
                panel.reveal(row);
                event.consume();
            });
        });
    }
}
