package dev.twister.gui;

/** There is no screen to open a window on; the message says so, and what can be done without one. */
public final class NoDisplayException extends RuntimeException {
    private static final long serialVersionUID = 1L;

    NoDisplayException(String why, Throwable cause) {
        super(
                "no window can be opened: " + why
                        + "; 'twister render SCENE -o FILE' and 'twister benchmark' need no display",
                cause);
    }
}
