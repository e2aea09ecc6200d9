package dev.twister.bench.report;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class ReportComparisonTest {
    private static final String HEAD = "{\"parameters\":{\"scene\":\"benchmark\"},\"results\":[";

    @TempDir
    private Path folder;

    private Path file(String name, String... reports) throws IOException {
        return Files.write(folder.resolve(name), List.of(reports));
    }

    private static String report(String engine, double median, double p95, boolean same) {
        return HEAD + "{\"engine\":\"" + engine + "\",\"width\":64,\"height\":36,\"shadowSamples\":1,\"bounces\":1,"
                + "\"frames\":4,\"msMedian\":" + median + ",\"msP95\":" + p95 + ",\"samePicture\":" + same + "}]}";
    }

    @ParameterizedTest
    @CsvSource({"104, true", "106, false", "50, true"})
    void steadyTimesAreHeldToTheLimit(double after, boolean passed) throws IOException {
        Path before = file("a.json", report("vector", 100, 100, true));
        ReportComparison found = ReportComparison.of(before, file("b.json", report("vector", after, after, true)), 5);
        assertThat(found.passed()).isEqualTo(passed);
        assertThat(found.ratios()).singleElement().satisfies(row -> {
            assertThat(row.name()).isEqualTo("benchmark vector 64x36 1/1");
            assertThat(row.ratio()).isEqualTo(after / 100);
            assertThat(row.uncertainty()).isZero();
        });
    }

    @Test
    void noiseIsNotTakenForALoss() throws IOException {
        Path before = file("a.json", report("vector", 100, 100, true));
        ReportComparison found = ReportComparison.of(before, file("b.json", report("vector", 110, 125, true)), 5);
        assertThat(found.passed()).isTrue();
        // Twice 1.253 x (15 / 1.645) / sqrt(4), of 100.
        assertThat(found.ratios().getFirst().uncertainty()).isBetween(0.1142, 0.1144);
    }

    @Test
    void theMiddleOfSeveralRunsCounts() throws IOException {
        Path before = file("a.json", report("vector", 100, 100, true));
        Path after = file(
                "b.jsonl",
                report("vector", 900, 900, true),
                report("vector", 101, 101, true),
                report("vector", 90, 90, true));
        assertThat(ReportComparison.of(before, after, 5).ratios().getFirst().afterMillis())
                .isEqualTo(101);
    }

    @Test
    void wrongPicturesAreNotComparedAndFail() throws IOException {
        Path before = file("a.json", report("vector", 100, 100, true));
        ReportComparison found = ReportComparison.of(before, file("b.json", report("vector", 1, 1, false)), 5);
        assertThat(found.passed()).isFalse();
        assertThat(found.ratios()).isEmpty();
        assertThat(found.table()).contains("benchmark vector 64x36 1/1: WRONG PICTURE");
    }

    @Test
    void filesWithNothingToCompareAreRefused() throws IOException {
        Path before = file("a.json", report("vector", 100, 100, true));
        Path other = file("b.json", report("parallel", 100, 100, true));
        assertThatThrownBy(() -> ReportComparison.of(before, other, 5))
                .isInstanceOf(IOException.class)
                .hasMessageEndingWith("have no scene, engine, size and quality in common");
        Path broken = file("c.json", "{");
        assertThatThrownBy(() -> ReportComparison.of(before, broken, 5))
                .isInstanceOf(IOException.class)
                .hasMessageStartingWith(broken + ": not valid JSON");
        Path empty = file("d.json", "{}");
        assertThatThrownBy(() -> ReportComparison.of(before, empty, 5))
                .isInstanceOf(IOException.class)
                .hasMessage(empty + ": holds no results of 'twister benchmark --json'");
    }
}
