package dev.twister.bench.report;

import dev.twister.bench.ReportNumbers;
import dev.twister.bench.Statistics;
import dev.twister.bench.benchmark.BenchmarkPlan;
import dev.twister.bench.benchmark.BenchmarkReport;
import dev.twister.bench.benchmark.MachineInfo;
import dev.twister.bench.benchmark.Measurement;
import dev.twister.engine.JvmEngines;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.Stream;

/** A report for a terminal with 120 columns, or more for several figures. */
public final class ReportTable {
    private static final int LEFT_ALIGNED = 3;
    private static final double MILLION = 1e6;
    private static final int MAX_DEVICE_LENGTH = 30;
    private static final List<String> TITLES = List.of(
            "engine",
            "device",
            "size",
            "frames",
            "FPS",
            "min ms",
            "median",
            "mean",
            "p95",
            "x sequential",
            "x parallel");
    private static final List<String> PATH_TITLES = List.of("M samples/s");
    private static final List<String> MOTION_TITLES = List.of("step ms", "rebuild ms");

    private ReportTable() {}

    /** The whole report: machine, table, then failures. */
    public static String of(BenchmarkReport report) {
        List<String> lines = new ArrayList<>();
        lines.addAll(heading(report));
        lines.add("");
        lines.addAll(table(report));
        List<String> problems = report.problems();
        if (!problems.isEmpty()) {
            lines.add("");
            problems.forEach(problem -> lines.add("FAILED: " + problem));
        }
        return String.join(System.lineSeparator(), lines);
    }

    private static List<String> heading(BenchmarkReport report) {
        BenchmarkPlan plan = report.plan();
        String measured = String.format(
                Locale.ROOT,
                "scene %s%s; up to %d + %d frames in %s s",
                report.scene(),
                plan.hasOneFigure() ? ", " + plan.settings().getFirst().shading() : "",
                plan.warmupFrames(),
                plan.frames(),
                ReportNumbers.shortest(plan.maxSeconds()));
        return joined(machine(report.machine()), List.of(measured));
    }

    /** Machine and software in two lines. */
    public static List<String> machine(MachineInfo machine) {
        return List.of(
                String.format(
                        Locale.ROOT,
                        "%s, %d cores, %.1f GiB, %s",
                        machine.processor(),
                        machine.cores(),
                        machine.memoryBytes() / (double) (1 << 30),
                        machine.operatingSystem()),
                String.format(
                        Locale.ROOT,
                        "Twister %s, JDK %s %s, %s%s",
                        machine.twister(),
                        machine.jdk(),
                        machine.vendor(),
                        machine.jit(),
                        machine.tornadoVm()
                                .map(version -> ", TornadoVM " + version)
                                .orElse("")));
    }

    private static List<String> table(BenchmarkReport report) {
        List<List<String>> rows = new ArrayList<>();
        boolean moving = report.measurements().stream()
                .anyMatch(measurement -> measurement.motionTimes().isPresent());
        boolean traced = report.measurements().stream()
                .anyMatch(measurement -> measurement.setting().paths().isPresent());
        List<String> titles = traced ? joined(TITLES, PATH_TITLES) : TITLES;
        rows.add(moving ? joined(titles, MOTION_TITLES) : titles);
        for (Measurement measurement : report.measurements()) {
            List<String> row = traced
                    ? joined(row(report, measurement), List.of(pathRate(measurement)))
                    : row(report, measurement);
            rows.add(moving ? joined(row, motion(measurement)) : row);
        }
        return aligned(rows);
    }

    /** Formats rows as lines, with the first three columns left-aligned. */
    static List<String> aligned(List<List<String>> rows) {
        int[] widths = IntStream.range(0, rows.getFirst().size())
                .map(column -> rows.stream()
                        .mapToInt(row -> row.get(column).length())
                        .max()
                        .orElse(0))
                .toArray();
        return rows.stream().map(row -> aligned(row, widths)).toList();
    }

    private static List<String> joined(List<String> first, List<String> second) {
        return Stream.concat(first.stream(), second.stream()).toList();
    }

    private static String pathRate(Measurement measurement) {
        return measurement
                .setting()
                .pathsPerSecond(measurement.times().fps())
                .map(rate -> ReportNumbers.legible(rate / MILLION, 2))
                .orElse("-");
    }

    private static List<String> motion(Measurement measurement) {
        return measurement
                .motionTimes()
                .map(times -> List.of(
                        String.format(Locale.ROOT, "%.2f", times.step()),
                        String.format(Locale.ROOT, "%.2f", times.rebuild())))
                .orElse(List.of("-", "-"));
    }

    private static List<String> row(BenchmarkReport report, Measurement measurement) {
        Statistics times = measurement.times();
        return List.of(
                measurement.engine(),
                shortened(measurement.device()),
                (report.plan().hasOneFigure() ? measurement.setting().size() : measurement.setting()).toString(),
                measurement.warmupFrames() + "+" + times.frames(),
                ReportNumbers.legible(times.fps(), 1),
                String.format(Locale.ROOT, "%.2f", times.min()),
                String.format(Locale.ROOT, "%.2f", times.median()),
                String.format(Locale.ROOT, "%.2f", times.mean()),
                String.format(Locale.ROOT, "%.2f", times.p95()),
                speedup(report.speedupOver(JvmEngines.SEQUENTIAL, measurement)),
                speedup(report.speedupOver(JvmEngines.PARALLEL, measurement)));
    }

    private static String aligned(List<String> row, int[] widths) {
        return IntStream.range(0, widths.length)
                .mapToObj(column -> {
                    String padding = " ".repeat(widths[column] - row.get(column).length());
                    return column < LEFT_ALIGNED ? row.get(column) + padding : padding + row.get(column);
                })
                .collect(Collectors.joining("  "));
    }

    private static String speedup(Optional<Double> speedup) {
        return speedup.map(factor -> ReportNumbers.legible(factor, 2)).orElse("-");
    }

    static String shortened(String device) {
        return device.length() <= MAX_DEVICE_LENGTH ? device : device.substring(0, MAX_DEVICE_LENGTH - 1) + "…";
    }
}
