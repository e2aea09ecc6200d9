package dev.twister.gui.controls;

import java.util.Locale;

/** The ids by which style sheets and tests find controls. */
public final class Ids {
    private Ids() {}

    /** The id of a control with that label, such as {@code shadow-samples}. */
    public static String of(String label) {
        return label.toLowerCase(Locale.ROOT).replace(' ', '-');
    }
}
