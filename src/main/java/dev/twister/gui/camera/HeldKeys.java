package dev.twister.gui.camera;

import dev.twister.world.animation.Turn;
import dev.twister.world.animation.Walk;
import java.util.EnumSet;
import java.util.Set;
import javafx.scene.input.KeyCode;

/** The camera keys that are held. */
final class HeldKeys {
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
