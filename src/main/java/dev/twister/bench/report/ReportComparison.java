package dev.twister.bench.report;

import dev.twister.bench.report.ReportReader.TimedRow;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.stream.Collectors;

/**
 * Two reports side by side. Where a file has several runs of a setting, the run with the median of the medians stands
 * for them.
 *
 * @param ratios of what both reports have, in the order of the first
 * @param lonely what is in one report alone
 * @param wrong rows whose picture was not that of {@code sequential}, which are not compared
 * @param limit the ratio of times from which on an engine is slower
 */
public record ReportComparison(List<Ratio> ratios, List<String> lonely, List<String> wrong, double limit) {
    /** Errors within this many standard errors are taken for noise: 95 % of them. */
    private static final double NOISE = 2;

    /**
     * A setting that both reports have.
     *
     * @param ratio the second median time over the first; below 1 where the second report is faster
     * @param uncertainty of the ratio, plus or minus, for 95 % of repetitions
     */
    public record Ratio(String name, double beforeMillis, double afterMillis, double ratio, double uncertainty) {}

    /**
     * Compares two files of {@link JsonReport}.
     *
     * @param withinPercent how much slower, beyond the uncertainty, is still equal
     * @throws IOException naming the file and what is wrong with it, or that the files have nothing in common
     */
    public static ReportComparison of(Path before, Path after, double withinPercent) throws IOException {
        Map<String, List<TimedRow>> first = byName(ReportReader.rows(before));
        Map<String, List<TimedRow>> second = byName(ReportReader.rows(after));
        List<Ratio> ratios = new ArrayList<>();
        List<String> lonely = new ArrayList<>();
        List<String> wrong = new ArrayList<>();
        for (Map.Entry<String, List<TimedRow>> entry : first.entrySet()) {
            List<TimedRow> others = second.get(entry.getKey());
            if (others == null) {
                lonely.add(entry.getKey() + ": in " + before + " alone");
            } else if (!isRight(entry.getValue()) || !isRight(others)) {
                wrong.add(entry.getKey());
            } else {
                ratios.add(ratio(middle(entry.getValue()), middle(others)));
            }
        }
        second.keySet().stream()
                .filter(name -> !first.containsKey(name))
                .forEach(name -> lonely.add(name + ": in " + after + " alone"));
        if (ratios.isEmpty() && wrong.isEmpty()) {
            throw new IOException(before + " and " + after + " have no scene, engine, size and quality in common");
        }
        return new ReportComparison(ratios, lonely, wrong, 1 + withinPercent / 100);
    }

    private static Map<String, List<TimedRow>> byName(List<TimedRow> rows) {
        return rows.stream().collect(Collectors.groupingBy(TimedRow::name, LinkedHashMap::new, Collectors.toList()));
    }

    private static boolean isRight(List<TimedRow> rows) {
        return rows.stream().allMatch(TimedRow::samePicture);
    }

    private static TimedRow middle(List<TimedRow> runs) {
        return runs.stream()
                .sorted(Comparator.comparingDouble(TimedRow::medianMillis))
                .toList()
                .get(runs.size() / 2);
    }

    private static Ratio ratio(TimedRow before, TimedRow after) {
        double ratio = after.medianMillis() / before.medianMillis();
        double error = Math.hypot(before.relativeError(), after.relativeError());
        return new Ratio(before.name(), before.medianMillis(), after.medianMillis(), ratio, NOISE * error * ratio);
    }

    /** Whether nothing is slower than the limit, beyond its uncertainty, and no picture is wrong. */
    public boolean passed() {
        return wrong.isEmpty() && ratios.stream().noneMatch(this::isSlower);
    }

    private boolean isSlower(Ratio row) {
        return row.ratio() - row.uncertainty() > limit;
    }

    /** A table for a terminal. */
    public String table() {
        int width = ratios.stream().mapToInt(row -> row.name().length()).max().orElse(0);
        StringBuilder text = new StringBuilder();
        line(text, width, "", "before ms", "after ms", "ratio", "+-", "");
        for (Ratio row : ratios) {
            line(
                    text,
                    width,
                    row.name(),
                    number(row.beforeMillis()),
                    number(row.afterMillis()),
                    number(row.ratio()),
                    number(row.uncertainty()),
                    isSlower(row) ? "  SLOWER" : row.ratio() + row.uncertainty() < 1 ? "  faster" : "");
        }
        wrong.forEach(name ->
                text.append(name).append(": WRONG PICTURE, not compared").append('\n'));
        lonely.forEach(name -> text.append(name).append('\n'));
        return text.toString().stripTrailing();
    }

    private static void line(StringBuilder text, int width, String name, String... cells) {
        text.append(String.format(
                Locale.ROOT,
                "%-" + Math.max(1, width) + "s  %10s  %10s  %7s  %6s%s%n",
                name,
                cells[0],
                cells[1],
                cells[2],
                cells[3],
                cells[4]));
    }

    private static String number(double value) {
        return String.format(Locale.ROOT, "%.3f", value);
    }
}
