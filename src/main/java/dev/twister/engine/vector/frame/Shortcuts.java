package dev.twister.engine.vector.frame;

/** Which shortcuts an engine takes. */
public final class Shortcuts {
    private final int taken;

    private Shortcuts(int taken) {
        this.taken = taken;
    }

    /** All of them. */
    public static Shortcuts all() {
        return new Shortcuts(-1);
    }

    /** None of them. */
    public static Shortcuts none() {
        return new Shortcuts(0);
    }

    /** All but one. */
    public static Shortcuts without(Shortcut shortcut) {
        return new Shortcuts(~bit(shortcut));
    }

    /** Whether that one is taken. */
    public boolean take(Shortcut shortcut) {
        return (taken & bit(shortcut)) != 0;
    }

    @SuppressWarnings("EnumOrdinal") // asked several times a tile, where a set would be slower
    private static int bit(Shortcut shortcut) {
        return 1 << shortcut.ordinal();
    }
}
