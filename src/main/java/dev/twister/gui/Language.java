package dev.twister.gui;

import java.util.Locale;

/** The language of all texts in the window, JavaFX's own included. */
final class Language {
    private Language() {}

    /** Called before JavaFX starts, which has texts in several languages and takes the system's. */
    static void choose() {
        Locale.setDefault(Locale.ENGLISH);
    }
}
