package dev.twister.cli;

import dev.twister.bench.BenchmarkReport;
import dev.twister.bench.CsvReport;
import dev.twister.bench.JsonReport;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;

/**
 * Where a benchmark's report goes. One that was stopped goes beside it, so that an older, finished one is not lost for it:
 * {@code report.json} to {@code report-unfinished.json}.
 */
record ReportFiles(Optional<Path> json, Optional<Path> csv) {
    private static final String UNFINISHED = "-unfinished";

    /**
     * Looks whether they can be written.
     *
     * @throws BadInputException where one cannot
     */
    void check() {
        json.ifPresent(file -> OutputFile.check("--json", file));
        csv.ifPresent(file -> OutputFile.check("--csv", file));
    }

    /**
     * Writes a finished report; unfinished ones are gone then.
     *
     * @throws IOException as {@link JsonReport#write}
     */
    void write(BenchmarkReport report) throws IOException {
        if (json.isPresent()) {
            JsonReport.write(report, json.get());
        }
        if (csv.isPresent()) {
            CsvReport.write(report, csv.get());
        }
        for (Path file : besides(json, csv)) {
            Files.deleteIfExists(file);
        }
    }

    /** Writes a report that was stopped, and returns what there is to say of it. */
    String writeUnfinished(BenchmarkReport report) {
        List<Path> besideJson = besides(json, Optional.empty());
        List<Path> besideCsv = besides(Optional.empty(), csv);
        try {
            for (Path file : besideJson) {
                JsonReport.write(report, file);
            }
            for (Path file : besideCsv) {
                CsvReport.write(report, file);
            }
        } catch (IOException problem) {
            return "no file could be written (" + problem.getMessage() + "), but this was measured:";
        }
        String files = besides(json, csv).stream().map(Path::toString).collect(Collectors.joining(" and "));
        return files.isEmpty() ? "this was measured:" : "what was measured is in " + files + ":";
    }

    /** Nothing goes beside a device or a pipe. */
    private static List<Path> besides(Optional<Path> json, Optional<Path> csv) {
        List<Path> files = new ArrayList<>();
        json.ifPresent(files::add);
        csv.ifPresent(files::add);
        return files.stream()
                .filter(file -> Files.notExists(file) || Files.isRegularFile(file))
                .map(ReportFiles::beside)
                .toList();
    }

    private static Path beside(Path file) {
        String name = file.getFileName().toString();
        int end = name.lastIndexOf('.') > 0 ? name.lastIndexOf('.') : name.length();
        return file.resolveSibling(name.substring(0, end) + UNFINISHED + name.substring(end));
    }
}
