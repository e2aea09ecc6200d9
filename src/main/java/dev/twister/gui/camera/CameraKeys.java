package dev.twister.gui.camera;

import dev.twister.gui.studio.Studio;
import dev.twister.world.animation.Turn;
import dev.twister.world.animation.Walk;
import java.util.EnumSet;
import java.util.List;
import java.util.Set;
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

    /** The camera keys that are held. */
    static final class HeldKeys {
        private static final Set<KeyCode> MOVING = EnumSet.of(
                KeyCode.W,
                KeyCode.A,
                KeyCode.S,
                KeyCode.D,
                KeyCode.Q,
                KeyCode.E,
                KeyCode.LEFT,
                KeyCode.RIGHT,
                KeyCode.UP,
                KeyCode.DOWN,
                KeyCode.SHIFT);

        private final Set<KeyCode> held = EnumSet.noneOf(KeyCode.class);
        private boolean qUp;

        /** Sets whether Q moves up and E down, instead of the other way round. */
        void setQUp(boolean up) {
            qUp = up;
        }

        /** Whether this key moves the camera. */
        boolean press(KeyCode key) {
            if (MOVING.contains(key)) {
                held.add(key);
                return true;
            }
            return false;
        }

        void release(KeyCode key) {
            held.remove(key);
        }

        void releaseAll() {
            held.clear();
        }

        /** The walk of the held keys; opposite ones cancel each other. */
        Walk walk() {
            return new Walk(
                    axis(KeyCode.D, KeyCode.A),
                    qUp ? axis(KeyCode.Q, KeyCode.E) : axis(KeyCode.E, KeyCode.Q),
                    axis(KeyCode.W, KeyCode.S),
                    held.contains(KeyCode.SHIFT));
        }

        /** The turn of the held arrow keys; opposite ones cancel each other. */
        Turn turn() {
            return new Turn(
                    axis(KeyCode.RIGHT, KeyCode.LEFT), axis(KeyCode.DOWN, KeyCode.UP), held.contains(KeyCode.SHIFT));
        }

        private int axis(KeyCode forth, KeyCode back) {
            return (held.contains(forth) ? 1 : 0) - (held.contains(back) ? 1 : 0);
        }
    }
}
