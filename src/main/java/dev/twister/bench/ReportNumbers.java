package dev.twister.bench;

import java.math.BigDecimal;
import java.math.MathContext;
import java.math.RoundingMode;

/** Formatting of numbers in reports. */
public final class ReportNumbers {
    /** Decimals of milliseconds, down to a nanosecond. */
    private static final int DECIMALS = 6;

    private static final MathContext LEAST_DIGITS = new MathContext(2, RoundingMode.HALF_UP);

    private ReportNumbers() {}

    /**
     * Formats with the given number of decimals, or more to show at least two significant digits, so that the rate of a
     * very slow engine is not 0.
     */
    public static String legible(double value, int decimals) {
        BigDecimal exact = BigDecimal.valueOf(value);
        return exact.setScale(Math.max(decimals, exact.round(LEAST_DIGITS).scale()), RoundingMode.HALF_UP)
                .toPlainString();
    }

    public static BigDecimal rounded(double value) {
        return BigDecimal.valueOf(value).setScale(DECIMALS, RoundingMode.HALF_UP);
    }

    /** A count with its noun, such as {@code 1 bounce} or {@code 3 bounces}. */
    public static String counted(int count, String thing) {
        return count + " " + thing + (count == 1 ? "" : "s");
    }

    /** Without a trailing {@code .0}. */
    public static String shortest(double value) {
        return BigDecimal.valueOf(value).stripTrailingZeros().toPlainString();
    }
}
