package dev.twister.gui.controls;

import javafx.application.Platform;
import javafx.scene.control.ComboBoxBase;
import javafx.scene.input.KeyCode;
import javafx.scene.input.KeyEvent;

/** Space opens what drops down, as it does in most programs, and Escape closes it and does nothing else. */
public final class DropDownKeys {
    private final ComboBoxBase<?> box;
    private boolean armed;
    private boolean justClosed;

    private DropDownKeys(ComboBoxBase<?> box) {
        this.box = box;
    }

    /** Filters, so that this comes before what else listens to the window. */
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

    /** What drops down hears of a key first, and does not keep it to itself. */
    private void closed() {
        justClosed = true;
        Platform.runLater(() -> justClosed = false);
    }

    /** A palette that is there already when the key is let go takes that for a choice. */
    private void released(KeyEvent event) {
        if (event.getCode() == KeyCode.SPACE && armed) {
            armed = false;
            box.show();
            event.consume();
        }
    }
}
