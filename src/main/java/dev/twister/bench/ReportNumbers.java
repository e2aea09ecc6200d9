package dev.twister.bench;

import java.math.BigDecimal;
import java.math.RoundingMode;

/** Numbers as the reports write them. */
final class ReportNumbers {
    /** A nanosecond, where the unit is a millisecond. */
    private static final int DECIMALS = 6;

    private ReportNumbers() {}

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
