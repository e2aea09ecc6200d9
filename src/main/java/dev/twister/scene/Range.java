package dev.twister.scene;

import java.math.BigDecimal;

/**
 * The numbers that a field may have, both ends inside.
 *
 * @param unit what is counted, for the message; may be empty
 */
record Range(double min, double max, String unit) {
    Range(double min, double max) {
        this(min, max, "");
    }

    boolean contains(double number) {
        return number >= min && number <= max;
    }

    /** {@code from -90 to 90 degrees}. */
    @Override
    public String toString() {
        return "from " + plain(min) + " to " + plain(max) + (unit.isEmpty() ? "" : " " + unit);
    }

    private static String plain(double number) {
        return BigDecimal.valueOf(number).stripTrailingZeros().toPlainString();
    }
}
