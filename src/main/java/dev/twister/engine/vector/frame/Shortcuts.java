package dev.twister.engine.vector.frame;

/** The set of shortcuts that an engine uses. */
public final class Shortcuts {
    private final int taken;

    private Shortcuts(int taken) {
        this.taken = taken;
    }

    /** All shortcuts. */
    public static Shortcuts all() {
        return new Shortcuts(-1);
    }

    /** No shortcuts. */
    public static Shortcuts none() {
        return new Shortcuts(0);
    }

    /** All shortcuts except one. */
    public static Shortcuts without(Shortcut shortcut) {
        return new Shortcuts(~bit(shortcut));
    }

    /** Whether the shortcut is enabled. */
    public boolean take(Shortcut shortcut) {
        return (taken & bit(shortcut)) != 0;
    }

    @SuppressWarnings("EnumOrdinal") // queried several times per tile, where a set would be slower
    private static int bit(Shortcut shortcut) {
        return 1 << shortcut.ordinal();
    }
}
