package dev.twister.gui.controls;

import javafx.application.Platform;
import javafx.scene.control.ComboBoxBase;
import javafx.scene.input.KeyCode;
import javafx.scene.input.KeyEvent;

/** Keys of drop-down controls: Space opens one, Escape only closes it. */
public final class DropDownKeys {
    private final ComboBoxBase<?> box;
    private boolean armed;
    private boolean justClosed;

    private DropDownKeys(ComboBoxBase<?> box) {
        this.box = box;
    }

    /** Adds event filters, which run before the window's handlers. */
    public static void install(ComboBoxBase<?> box) {
        DropDownKeys keys = new DropDownKeys(box);
        box.addEventFilter(KeyEvent.KEY_PRESSED, keys::pressed);
        box.addEventFilter(KeyEvent.KEY_RELEASED, keys::released);
        box.showingProperty().subscribe((_, shown) -> {
            if (!shown) {
                keys.closed();
            }
        });
    }

    private void pressed(KeyEvent event) {
        if (event.getCode() == KeyCode.SPACE && !box.isShowing()) {
            armed = true;
            event.consume();
        } else if (event.getCode() == KeyCode.ESCAPE && justClosed) {
            event.consume();
        }
    }

    /** The popup gets the key first, but does not consume it. */
    private void closed() {
        justClosed = true;
        Platform.runLater(() -> justClosed = false);
    }

    /** A palette that is already open when the key is released would take that as a choice. */
    private void released(KeyEvent event) {
        if (event.getCode() == KeyCode.SPACE && armed) {
            armed = false;
            box.show();
            event.consume();
        }
    }
}
