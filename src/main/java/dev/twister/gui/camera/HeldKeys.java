package dev.twister.gui.camera;

import dev.twister.world.Turn;
import dev.twister.world.Walk;
import java.util.EnumSet;
import java.util.Set;
import javafx.scene.input.KeyCode;

/** The keys that move the camera for as long as they are held. */
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

    /** Whether Q leads up and E down, instead of the other way round. */
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

    /** Where the held keys lead; opposite ones cancel each other. */
    Walk walk() {
        return new Walk(
                axis(KeyCode.D, KeyCode.A),
                qUp ? axis(KeyCode.Q, KeyCode.E) : axis(KeyCode.E, KeyCode.Q),
                axis(KeyCode.W, KeyCode.S),
                held.contains(KeyCode.SHIFT));
    }

    /** Which way the held arrow keys turn the camera; opposite ones cancel each other. */
    Turn turn() {
        return new Turn(
                axis(KeyCode.RIGHT, KeyCode.LEFT), axis(KeyCode.DOWN, KeyCode.UP), held.contains(KeyCode.SHIFT));
    }

    private int axis(KeyCode forth, KeyCode back) {
        return (held.contains(forth) ? 1 : 0) - (held.contains(back) ? 1 : 0);
    }
}
