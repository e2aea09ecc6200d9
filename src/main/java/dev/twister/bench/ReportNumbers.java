package dev.twister.bench;

import java.math.BigDecimal;
import java.math.MathContext;
import java.math.RoundingMode;

/** Numbers as the reports write them. */
public final class ReportNumbers {
    /** A nanosecond, where the unit is a millisecond. */
    private static final int DECIMALS = 6;

    private static final MathContext LEAST_DIGITS = new MathContext(2, RoundingMode.HALF_UP);

    private ReportNumbers() {}

    /**
     * With this number of decimals, and with more where fewer than two digits would count: the rate of an engine that
     * needs a minute for a frame is not 0.
     */
    public static String legible(double value, int decimals) {
        BigDecimal exact = BigDecimal.valueOf(value);
        return exact.setScale(Math.max(decimals, exact.round(LEAST_DIGITS).scale()), RoundingMode.HALF_UP)
                .toPlainString();
    }

    static BigDecimal rounded(double value) {
        return BigDecimal.valueOf(value).setScale(DECIMALS, RoundingMode.HALF_UP);
    }

    /** So many of a thing, such as {@code 1 bounce} or {@code 3 bounces}. */
    static String counted(int count, String thing) {
        return count + " " + thing + (count == 1 ? "" : "s");
    }

    /** Without a needless {@code .0}. */
    static String shortest(double value) {
        return BigDecimal.valueOf(value).stripTrailingZeros().toPlainString();
    }
}
