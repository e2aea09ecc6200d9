package dev.twister.bench.benchmark;

import dev.twister.bench.ReportNumbers;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;

/** Which engine is the fastest at how many settings. */
public final class FastestEngines {
    private FastestEngines() {}

    /** Such as "The fastest engine of 15 settings: vector at 14, parallel at 1."; empty where nothing was measured. */
    public static String sentence(BenchmarkReport report) {
        Map<String, Long> wins = report.plan().settings().stream()
                .flatMap(setting -> at(report, setting).stream())
                .map(Measurement::engine)
                .collect(Collectors.groupingBy(engine -> engine, LinkedHashMap::new, Collectors.counting()));
        long settings = wins.values().stream().mapToLong(count -> count).sum();
        if (settings == 0) {
            return "";
        }
        String counts = wins.entrySet().stream()
                .sorted(Map.Entry.<String, Long>comparingByValue().reversed())
                .map(win -> win.getKey() + " at " + win.getValue())
                .collect(Collectors.joining(", "));
        return "The fastest engine of " + ReportNumbers.counted((int) settings, "setting") + ": " + counts + ".";
    }

    /** The measurement of the fastest engine at a setting; empty if none was measured there. */
    public static Optional<Measurement> at(BenchmarkReport report, Setting setting) {
        return report.engines().stream()
                .flatMap(engine -> report.find(engine, setting).stream())
                .max(Comparator.comparingDouble(
                        measurement -> measurement.times().fps()));
    }
}
