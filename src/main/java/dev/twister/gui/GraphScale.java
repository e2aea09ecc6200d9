package dev.twister.gui;

import java.util.Locale;

/** The upper end of the graph: a number that one can read, above all that is shown. */
final class GraphScale {
    private static final double[] STEPS = {1, 2, 5, 10};

    private GraphScale() {}

    /** The next of 1, 2, 5, 10, 20, ... milliseconds. */
    static double above(double millis) {
        double decade = Math.pow(10, Math.floor(Math.log10(Math.max(1, millis))));
        for (double step : STEPS) {
            if (millis <= step * decade) {
                return step * decade;
            }
        }
        return 10 * decade;
    }

    static String label(double millis) {
        return String.format(Locale.ROOT, millis == Math.rint(millis) ? "%.0f ms" : "%.1f ms", millis);
    }
}
