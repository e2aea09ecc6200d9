package dev.twister.bench.report;

import static org.assertj.core.api.Assertions.assertThat;

import dev.twister.bench.benchmark.BenchmarkTest;
import java.io.IOException;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import tools.jackson.databind.JsonNode;

class JitReportTest {
    @TempDir
    private Path folder;

    @Test
    void ratesStandSideBySide() throws IOException {
        JitReport report = report(List.of("device", "parallel"), List.of("device"));

        assertThat(report.passed()).isTrue();
        assertThat(report.table().lines().filter(line -> line.contains("  5x3  ")))
                .containsExactly(
                        "device    a device of the test's  5x3     90.9       90.9        1.00",
                        "parallel  a device of the test's  5x3    250.0          -           -");
        assertThat(report.table()).contains("FPS c2  FPS graal  c2 / graal", "JDK " + Runtime.version());
    }

    @Test
    void whatFailedAndWhatIsWrongIsToldByItsCompiler() throws IOException {
        JitReport report = report(List.of("parallel"), List.of("broken", "wrong"));

        assertThat(report.passed()).isFalse();
        assertThat(report.table())
                .contains(
                        "FAILED with graal: wrong at 5x3 differs from the picture of sequential",
                        "FAILED with graal: broken: out of order");
    }

    @Test
    void bothReportsAreInOneFile() throws IOException {
        Path file = folder.resolve("both.json");
        report(List.of("device"), List.of("parallel")).write(file);

        JsonNode both = JitReport.read(file);
        assertThat(both.propertyNames()).containsExactly("c2", "graal");
        assertThat(both.at("/graal/results/0/engine").asString()).isEqualTo("parallel");
    }

    private JitReport report(List<String> c2, List<String> graal) throws IOException {
        Map<String, JsonNode> reports = new LinkedHashMap<>();
        reports.put("c2", measured(c2));
        reports.put("graal", measured(graal));
        return new JitReport(reports);
    }

    private JsonNode measured(List<String> engines) throws IOException {
        Path file = folder.resolve("one.json");
        JsonReport.write(BenchmarkTest.run(BenchmarkTest.plan(engines, 0, 1, 100)), file);
        return JitReport.read(file);
    }
}
