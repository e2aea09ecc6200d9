package dev.twister.gui.camera;

import dev.twister.gui.studio.Studio;
import java.util.List;
import javafx.beans.value.ObservableValue;
import javafx.event.EventTarget;
import javafx.scene.Scene;
import javafx.scene.control.Control;
import javafx.scene.control.TextInputControl;
import javafx.scene.input.KeyCode;
import javafx.scene.input.KeyEvent;

/**
 * Moves the camera by the keyboard: W A S D, Q and E, the arrows to look, Shift to run, Home, and number keys for
 * views. Keys that a control consumes do not arrive here.
 */
public final class CameraKeys {
    private static final List<KeyCode> DIGITS = List.of(
            KeyCode.DIGIT0,
            KeyCode.DIGIT1,
            KeyCode.DIGIT2,
            KeyCode.DIGIT3,
            KeyCode.DIGIT4,
            KeyCode.DIGIT5,
            KeyCode.DIGIT6,
            KeyCode.DIGIT7,
            KeyCode.DIGIT8,
            KeyCode.DIGIT9);
    private static final List<KeyCode> KEYPAD = List.of(
            KeyCode.NUMPAD0,
            KeyCode.NUMPAD1,
            KeyCode.NUMPAD2,
            KeyCode.NUMPAD3,
            KeyCode.NUMPAD4,
            KeyCode.NUMPAD5,
            KeyCode.NUMPAD6,
            KeyCode.NUMPAD7,
            KeyCode.NUMPAD8,
            KeyCode.NUMPAD9);

    private final Studio studio;
    private final HeldKeys held = new HeldKeys();

    private CameraKeys(Studio studio) {
        this.studio = studio;
    }

    /** Adds handlers to the window, whichever control has the focus. */
    public static CameraKeys install(Scene scene, Studio studio) {
        CameraKeys keys = new CameraKeys(studio);
        scene.addEventHandler(KeyEvent.KEY_PRESSED, keys::pressed);
        scene.addEventHandler(KeyEvent.KEY_RELEASED, event -> {
            keys.held.release(event.getCode());
            keys.move();
        });
        return keys;
    }

    /** The release of a key is not reported once another window has the focus. */
    public void releaseWithout(ObservableValue<Boolean> windowFocused) {
        windowFocused.subscribe(focused -> {
            if (!focused) {
                held.releaseAll();
                move();
            }
        });
    }

    /** See {@link HeldKeys#setQUp}. */
    public void setQUp(boolean up) {
        held.setQUp(up);
        move();
    }

    private void pressed(KeyEvent event) {
        if (isText(event.getTarget()) || event.isAltDown() || event.isMetaDown()) {
            return;
        }
        // Among controls the arrows move the focus.
        if (event.getCode().isArrowKey() && event.getTarget() instanceof Control) {
            return;
        }
        int digit = digit(event.getCode());
        if (digit >= 0 && event.isShortcutDown()) {
            studio.cameraControl().keepView(digit);
        } else if (digit >= 0) {
            studio.cameraControl().recallView(digit);
        } else if (event.isShortcutDown()) {
            return;
        } else if (event.getCode() == KeyCode.HOME) {
            studio.cameraControl().goHome();
        } else if (held.press(event.getCode())) {
            move();
        } else {
            return;
        }
        event.consume();
    }

    private void move() {
        studio.cameraControl().setWalk(held.walk());
        studio.cameraControl().setTurn(held.turn());
    }

    private static boolean isText(EventTarget target) {
        return target instanceof TextInputControl;
    }

    private static int digit(KeyCode code) {
        return Math.max(DIGITS.indexOf(code), KEYPAD.indexOf(code));
    }
}
