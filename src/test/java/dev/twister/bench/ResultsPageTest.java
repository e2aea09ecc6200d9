package dev.twister.bench;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import tools.jackson.databind.json.JsonMapper;

class ResultsPageTest {
    @TempDir
    private Path folder;

    private static String report(String processor, String... rows) {
        return "{\"time\":\"2026-03-04T05:06:07Z\",\"machine\":{\"processor\":\"" + processor
                + "\",\"cores\":2,\"twister\":\"0.1.0\"},\"parameters\":{\"scene\":\"benchmark\"},\"results\":["
                + String.join(",", rows) + "]}";
    }

    private static String row(String engine, int width, int height, double fps, String more) {
        return "{\"engine\":\"" + engine + "\",\"device\":\"a device\",\"width\":" + width + ",\"height\":" + height
                + ",\"shadowSamples\":200,\"bounces\":3,\"frames\":5,\"fps\":" + fps + more + "}";
    }

    private static String same(String engine, int width, int height, double fps) {
        return row(engine, width, height, fps, ",\"samePicture\":true");
    }

    private ResultsPage.Written page(String... lines) throws IOException {
        return ResultsPage.write(folder, List.of(Files.write(folder.resolve("results.jsonl"), List.of(lines))));
    }

    @Test
    void enginesAreRowsAndSizesAreColumnsFromTheSmallest() throws IOException {
        ResultsPage.Written written =
                page(report("A", same("vector", 1920, 1080, 50), same("vector", 1280, 720, 120.25)));

        assertThat(written.rows()).isEqualTo(1);
        assertThat(Files.readString(written.page()))
                .containsSubsequence("<button>720p</button>", "<button>1080p</button>")
                .contains("<td>vector</td><td>benchmark</td><td>200/3</td><td>120.3</td><td>50.0</td>"
                        + "<td>0.1.0, 2026-03-04</td>");
    }

    @Test
    void everyReportOfEveryFileIsLinkedAsItsLog() throws IOException {
        ResultsPage.Written written =
                page(report("A", same("vector", 64, 36, 9)), report("B", same("vector", 64, 36, 8)));

        assertThat(Files.readString(written.page()))
                .contains("<a href=\"report-1.json\">", "<a href=\"report-2.json\">");
        assertThat(new JsonMapper()
                        .readTree(folder.resolve("report-2.json").toFile())
                        .path("machine")
                        .path("processor")
                        .asString())
                .isEqualTo("B");
    }

    @Test
    void resultsThatHoldMoreThanNumbersAreRefusedWithTheirLine() {
        for (String more : List.of("\"samplesPerPixel\":{}", "\"shadowSamples\":[1]", "\"engine\":{\"a\":1}")) {
            assertThatThrownBy(() -> page(
                            report("A", same("vector", 64, 36, 9)),
                            report("B", row("vector", 64, 36, 8, "," + more + ",\"samePicture\":true"))))
                    .isInstanceOf(IOException.class)
                    .hasMessageContaining("results.jsonl: line 2: result 1: ")
                    .hasMessageContaining("must be a number or a text, but is ");
        }
    }

    @Test
    void resultsWithAnotherPictureOrNoneAreRefused() throws IOException {
        ResultsPage.Written written = page(report(
                "A",
                row("wrong", 64, 36, 99, ",\"samePicture\":false"),
                row("unchecked", 64, 36, 98, ""),
                same("right", 64, 36, 1)));

        assertThat(written.rows()).isEqualTo(1);
        assertThat(written.refused())
                .hasSize(2)
                .allMatch(line -> line.endsWith("rendered another picture than sequential, or none was compared"));
        assertThat(Files.readString(written.page())).doesNotContain("<td>99", "<td>98");
    }

    @Test
    void thePapersOwnRatesStandBesideOurs() throws IOException {
        assertThat(Files.readString(
                        page(report("A", same("vector", 1280, 720, 120))).page()))
                .contains("<tr class=\"theirs\"><td>the paper's</td><td>RTX 2060</td>")
                .contains("<td>1/1</td><td>234.0</td>");
    }

    @Test
    void foreignTextIsNoMarkup() throws IOException {
        assertThat(Files.readString(page(report("<script>alert(1)</script>", same("<b>", 64, 36, 1)))
                        .page()))
                .doesNotContain("<script>alert", "<b>");
    }

    @Test
    void aFileWithoutResultsIsRefusedByName() {
        assertThatThrownBy(() -> page("{\"results\":[]}"))
                .isInstanceOf(IOException.class)
                .hasMessageContaining("results.jsonl: holds no results");
    }
}
