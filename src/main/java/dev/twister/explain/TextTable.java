package dev.twister.explain;

import dev.twister.scene.Rgb;
import dev.twister.scene.Vector3;
import java.util.List;
import java.util.Locale;
import java.util.stream.Collectors;
import java.util.stream.IntStream;

/** Aligned columns, and the numbers in them. */
final class TextTable {
    private static final String GAP = "  ";

    private TextTable() {}

    /**
     * Lines that end with a line feed each.
     *
     * @param texts number of columns that are aligned at their left, the first ones
     */
    static String of(List<List<String>> rows, int texts) {
        int[] widths = IntStream.range(0, rows.getFirst().size())
                .map(column -> rows.stream()
                        .mapToInt(row -> row.get(column).length())
                        .max()
                        .orElse(0))
                .toArray();
        return rows.stream()
                .map(row -> IntStream.range(0, widths.length)
                        .mapToObj(column -> padded(row.get(column), widths[column], column < texts))
                        .collect(Collectors.joining(GAP, "", "\n")))
                .collect(Collectors.joining());
    }

    private static String padded(String text, int width, boolean left) {
        String spaces = " ".repeat(width - text.length());
        return left ? text + spaces : spaces + text;
    }

    static String vector(Vector3 vector) {
        return number("(%.3f", vector.x()) + number(", %.3f", vector.y()) + number(", %.3f)", vector.z());
    }

    static String rgb(Rgb color) {
        return number("%.5f", color.red()) + number(" %.5f", color.green()) + number(" %.5f", color.blue());
    }

    static String number(String format, double value) {
        // Without the sign of a zero, which says nothing here.
        return String.format(Locale.ROOT, format, value + 0.0);
    }
}
