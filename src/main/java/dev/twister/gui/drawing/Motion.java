package dev.twister.gui.drawing;

/**
 * Whether and how bodies move.
 *
 * @param start the number of the start; a new number restarts the bodies from their places in the scene; 0 for no
 *     motion
 * @param running whether time passes
 * @param steps number of single steps since the start
 */
public record Motion(long start, boolean running, long steps) {
    /** No motion. */
    public static final Motion NONE = new Motion(0, false, 0);

    /** Whether physics places the bodies. */
    public boolean isOn() {
        return start != 0;
    }
}
