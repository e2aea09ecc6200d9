package dev.twister.cli.file;

import dev.twister.bench.benchmark.BenchmarkReport;
import dev.twister.bench.report.CsvReport;
import dev.twister.bench.report.JsonReport;
import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import picocli.CommandLine;

/**
 * Where a benchmark's report goes. One that was stopped goes beside it, so that an older, finished one is not lost for
 * it: {@code report.json} to {@code report-unfinished.json}.
 */
public record ReportFiles(Optional<Path> json, Optional<Path> csv) {
    private static final String UNFINISHED = "-unfinished";

    /**
     * Looks whether they can be written.
     *
     * @throws BadInputException where one cannot, or would replace the other
     */
    public void check() throws IOException {
        json.ifPresent(file -> OutputFile.checkText("--json", file));
        csv.ifPresent(file -> OutputFile.checkText("--csv", file));
        if (json.isPresent() && csv.isPresent() && OutputFile.replaces(json.get(), csv.get())) {
            throw new BadInputException("--json and --csv are both " + csv.get() + ", but must be two files");
        }
    }

    /**
     * Looks whether what is measured stays as it is.
     *
     * @throws BadInputException where a report would replace one of these files
     */
    public void checkKeeps(List<Path> inputs) throws IOException {
        if (json.isPresent()) {
            OutputFile.checkKeeps("--json", json.get(), inputs);
        }
        if (csv.isPresent()) {
            OutputFile.checkKeeps("--csv", csv.get(), inputs);
        }
    }

    /** Where the table goes: not among a report on standard output. */
    public PrintWriter tables(CommandLine command) {
        boolean taken = Stream.concat(json.stream(), csv.stream()).anyMatch(OutputFile::isStandardOutput);
        return taken ? command.getErr() : command.getOut();
    }

    /**
     * Writes a finished report; unfinished ones are gone then.
     *
     * @throws IOException as {@link JsonReport#write}
     */
    public void write(BenchmarkReport report) throws IOException {
        if (json.isPresent()) {
            JsonReport.write(report, json.get());
        }
        if (csv.isPresent()) {
            CsvReport.write(report, csv.get());
        }
        for (Optional<Path> file : List.of(beside(json), beside(csv))) {
            if (file.isPresent()) {
                Files.deleteIfExists(file.get());
            }
        }
    }

    /** Writes a report that was stopped, and returns what there is to say of it. */
    public String writeUnfinished(BenchmarkReport report) {
        List<String> written = new ArrayList<>();
        Optional<Path> besideJson = beside(json);
        Optional<Path> besideCsv = beside(csv);
        try {
            if (besideJson.isPresent()) {
                JsonReport.write(report, besideJson.get());
                written.add(besideJson.get().toString());
            }
            if (besideCsv.isPresent()) {
                CsvReport.write(report, besideCsv.get());
                written.add(besideCsv.get().toString());
            }
        } catch (IOException problem) {
            String files = written.isEmpty() ? "no file" : "no file but " + written.getFirst();
            return files + " could be written (" + problem.getMessage() + "), but this was measured:";
        }
        return written.isEmpty()
                ? "this was measured:"
                : "what was measured is in " + String.join(" and ", written) + ":";
    }

    /** Nothing goes beside a device or a pipe. */
    private static Optional<Path> beside(Optional<Path> file) {
        return file.filter(path -> !OutputFile.isStandardOutput(path))
                .filter(path -> Files.notExists(path) || Files.isRegularFile(path))
                .map(ReportFiles::beside);
    }

    private static Path beside(Path file) {
        String name = file.getFileName().toString();
        int end = name.lastIndexOf('.') > 0 ? name.lastIndexOf('.') : name.length();
        return file.resolveSibling(name.substring(0, end) + UNFINISHED + name.substring(end));
    }
}
