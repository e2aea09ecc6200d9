package dev.twister.gui.drawing;

/**
 * Whether and how bodies move.
 *
 * @param start counts up: a new number lets the bodies start anew from where the scene has them; 0 where they stand as
 *     the scene has them
 * @param running whether time passes
 * @param steps the single steps that were asked for since the start
 */
public record Motion(long start, boolean running, long steps) {
    /** All stands where the scene has it. */
    public static final Motion NONE = new Motion(0, false, 0);

    /** Whether bodies are where the physics has them. */
    public boolean isOn() {
        return start != 0;
    }
}
