package dev.twister.gui;

import java.util.Locale;

/** Whether there is a screen. */
final class Display {
    private static final String TOOLKIT = "glass.platform";

    private Display() {}

    /**
     * Looks before JavaFX does, which would end with a stack trace on its own thread.
     *
     * @throws NoDisplayException if there is certainly no screen
     */
    static void check() {
        boolean unix =
                !System.getProperty("os.name", "").toLowerCase(Locale.ROOT).matches("(windows|mac).*");
        if (unix && System.getProperty(TOOLKIT) == null && isEmpty(System.getenv("DISPLAY"))) {
            throw new NoDisplayException("DISPLAY is not set", null);
        }
    }

    private static boolean isEmpty(String value) {
        return value == null || value.isEmpty();
    }

    /** What kept JavaFX from starting, in a few words. */
    static String explain(Throwable problem) {
        Throwable cause = problem;
        while (cause.getCause() != null) {
            cause = cause.getCause();
        }
        return String.valueOf(cause.getMessage()).lines().findFirst().orElse("JavaFX did not start");
    }
}
