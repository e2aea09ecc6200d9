package dev.twister.gui.picture;

import java.util.Locale;

/** The upper end of the graph: a number that one can read, above all that is shown. */
public final class GraphScale {
    private static final double MOST_MILLIS = 1000;
    private static final double[] STEPS = {1, 2, 5, 10};

    private GraphScale() {}

    /** The next of 1, 2, 5, 10, 20, ... milliseconds. */
    public static double above(double millis) {
        double decade = Math.pow(10, Math.floor(Math.log10(Math.max(1, millis))));
        for (double step : STEPS) {
            if (millis <= step * decade) {
                return step * decade;
            }
        }
        return 10 * decade;
    }

    /** A time on a scale that ends at {@code topMillis}: all of its labels have one unit, and few letters. */
    public static String label(double millis, double topMillis) {
        boolean seconds = topMillis > MOST_MILLIS;
        double number = seconds ? millis / MOST_MILLIS : millis;
        return String.format(Locale.ROOT, number == Math.rint(number) ? "%.0f" : "%.1f", number)
                + (seconds ? " s" : " ms");
    }
}
