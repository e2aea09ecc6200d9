package dev.twister.engine.vector.frame;

import java.util.EnumSet;

/** Which shortcuts an engine takes. */
public final class Shortcuts {
    private final EnumSet<Shortcut> taken;

    private Shortcuts(EnumSet<Shortcut> taken) {
        this.taken = taken;
    }

    /** All of them. */
    public static Shortcuts all() {
        return new Shortcuts(EnumSet.allOf(Shortcut.class));
    }

    /** None of them. */
    public static Shortcuts none() {
        return new Shortcuts(EnumSet.noneOf(Shortcut.class));
    }

    /** All but one. */
    public static Shortcuts without(Shortcut shortcut) {
        return new Shortcuts(EnumSet.complementOf(EnumSet.of(shortcut)));
    }

    /** Whether that one is taken. */
    public boolean take(Shortcut shortcut) {
        return taken.contains(shortcut);
    }
}
