package dev.twister.bench.results;

import dev.twister.bench.PublishedFigures;
import dev.twister.bench.ReportNumbers;
import dev.twister.bench.page.HtmlText;
import dev.twister.bench.paper.PaperFolder;
import dev.twister.bench.results.SharedResults.ResultRow;
import dev.twister.files.WholeFile;
import dev.twister.image.PictureSize;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** Results of many machines as a page that needs no server: engines and devices as rows, sizes as columns. */
public final class ResultsPage {
    private static final String SCRIPT = "sort.js";
    private static final List<String> FACTS = List.of("machine", "device", "engine", "scene", "quality");

    private final SharedResults results;
    private final List<PictureSize> sizes;

    private ResultsPage(SharedResults results) {
        this.results = results;
        this.sizes = results.rows().stream()
                .flatMap(row -> row.fps().keySet().stream())
                .distinct()
                .sorted(Comparator.comparingLong(size -> (long) size.width() * size.height()))
                .toList();
    }

    /**
     * What was written.
     *
     * @param page its file
     * @param rows of the table
     * @param refused results that are not in the table, one line each
     */
    public record Written(Path page, int rows, List<String> refused) {}

    /**
     * Writes the page, and beside it each report.
     *
     * @param folder must exist
     * @param files reports as JSON, or lines of them
     * @throws IOException naming the file that cannot be read or written
     */
    public static Written write(Path folder, List<Path> files) throws IOException {
        SharedResults results = SharedResults.of(files);
        for (Map.Entry<String, String> log : results.logs().entrySet()) {
            writeText(folder.resolve(log.getKey()), log.getValue());
        }
        Path page = folder.resolve(PaperFolder.PAGE);
        writeText(page, new ResultsPage(results).text());
        return new Written(page, results.rows().size(), results.refused());
    }

    private static void writeText(Path file, String text) throws IOException {
        WholeFile.write(file, out -> out.write(text.getBytes(StandardCharsets.UTF_8)));
    }

    private String text() throws IOException {
        return HtmlText.page(
                "Twister: measured frame rates",
                "Measured frame rates",
                "Frames per second of Twister's engines, as 'twister benchmark' measured them. Every picture was equal"
                        + " to the one of sequential. Click a heading to sort.",
                table() + "<p class=\"note\">Quality is shadow samples / bounces, or paths per pixel. Gray rows are"
                        + " the paper's own figures (" + HtmlText.escaped(PublishedFigures.PAPER)
                        + "), not measured by Twister.</p>\n" + refused() + "<script>\n" + HtmlText.resource(SCRIPT)
                        + "</script>\n");
    }

    private String table() {
        String head = Stream.of(FACTS.stream(), sizes.stream().map(PictureSize::name), Stream.of("Twister", "report"))
                .flatMap(titles -> titles)
                .map(title -> "<th><button>" + HtmlText.escaped(title) + "</button></th>")
                .collect(Collectors.joining());
        String rows = results.rows().stream().map(this::row).collect(Collectors.joining());
        return "<div class=\"scroll\"><table class=\"sortable\">\n<thead><tr>" + head + "</tr></thead>\n<tbody>\n"
                + rows + published() + "</tbody></table></div>\n";
    }

    private String row(ResultRow row) {
        String log = HtmlText.escaped(row.log());
        return "<tr>"
                + cells(row.machine(), row.device(), row.engine(), row.scene(), row.quality())
                + sizes.stream()
                        .map(size -> number(Optional.ofNullable(row.fps().get(size))))
                        .collect(Collectors.joining())
                + cells(row.made()) + "<td><a href=\"" + log + "\">" + log + "</a></td></tr>\n";
    }

    /** The paper's rates, where a size of the table is one of the paper's. */
    private String published() {
        boolean comparable = results.rows().stream().anyMatch(ResultRow::isOfThePaper)
                || sizes.stream().anyMatch(size -> PublishedFigures.fps(size).isPresent());
        return comparable
                ? "<tr class=\"theirs\">"
                        + cells("the paper's", PublishedFigures.DEVICE, "TornadoVM", "benchmark", "1/1")
                        + sizes.stream()
                                .map(size -> number(PublishedFigures.fps(size)))
                                .collect(Collectors.joining())
                        + cells("-", "the paper") + "</tr>\n"
                : "";
    }

    private String refused() {
        return results.refused().isEmpty()
                ? ""
                : "<section>\n<h2>Refused</h2>\n<ul>\n"
                        + results.refused().stream()
                                .map(line -> "<li>" + HtmlText.escaped(line) + "</li>\n")
                                .collect(Collectors.joining())
                        + "</ul>\n</section>\n";
    }

    private static String cells(String... texts) {
        return Stream.of(texts)
                .map(text -> "<td>" + HtmlText.escaped(text) + "</td>")
                .collect(Collectors.joining());
    }

    private static String number(Optional<Double> fps) {
        return "<td>" + fps.map(rate -> ReportNumbers.legible(rate, 1)).orElse("") + "</td>";
    }
}
