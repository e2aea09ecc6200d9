package dev.twister.bench;

import dev.twister.files.WholeFile;
import java.io.IOException;
import java.io.OutputStreamWriter;
import java.io.Writer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import org.apache.commons.csv.CSVFormat;
import org.apache.commons.csv.CSVPrinter;

/** The evaluation for spreadsheets: a line for each figure, setting and engine, in the columns of {@link CsvReport} and two more. */
final class PaperCsv {
    private static final String FIGURE = "figure";
    private static final String FINISHED = "finished";

    private PaperCsv() {}

    static void write(PaperReport report, Path file) throws IOException {
        List<String> columns = Stream.of(List.of(FIGURE), CsvReport.COLUMNS, List.of(FINISHED))
                .flatMap(List::stream)
                .toList();
        WholeFile.write(file, out -> {
            Writer writer = new OutputStreamWriter(out, StandardCharsets.UTF_8);
            CSVPrinter printer = CSVFormat.RFC4180
                    .builder()
                    .setHeader(columns.toArray(String[]::new))
                    .get()
                    .print(writer);
            for (Map<String, Object> row : rows(report)) {
                printer.printRecord(columns.stream()
                        .map(column -> row.getOrDefault(column, ""))
                        .toList());
            }
            printer.flush();
        });
    }

    private static List<Map<String, Object>> rows(PaperReport report) {
        Map<String, Object> common = new LinkedHashMap<>(PaperFields.ofPlan(report));
        common.putAll(ReportFields.ofMachine(report.machine()));
        common.put(FINISHED, report.finished());
        Stream<Map<String, Object>> measured = Stream.of(PaperFigure.values())
                .flatMap(figure -> PaperFields.ofFigure(report, figure).stream()
                        .map(row -> with(row, Map.of(FIGURE, figure.id()))));
        Stream<Map<String, Object>> failed = report.failures().stream()
                .map(failure -> Map.of("engine", failure.engine(), "failure", failure.message()));
        return Stream.concat(measured, failed).map(row -> with(common, row)).toList();
    }

    private static Map<String, Object> with(Map<String, Object> some, Map<String, Object> more) {
        Map<String, Object> both = new LinkedHashMap<>(some);
        both.putAll(more);
        return both;
    }
}
