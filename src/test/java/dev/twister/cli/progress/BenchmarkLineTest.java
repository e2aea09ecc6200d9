package dev.twister.cli.progress;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import dev.twister.bench.benchmark.Benchmark;
import dev.twister.bench.benchmark.BenchmarkPlan;
import dev.twister.bench.benchmark.BenchmarkReport;
import dev.twister.bench.benchmark.MachineInfo;
import dev.twister.bench.benchmark.Setting;
import dev.twister.cli.file.ReportFiles;
import dev.twister.cli.file.SceneFiles;
import dev.twister.engine.Engine;
import dev.twister.engine.EngineException;
import dev.twister.engine.Engines;
import dev.twister.image.PictureSize;
import dev.twister.scene.Scene;
import dev.twister.scene.format.SceneReader;
import dev.twister.sky.SkyboxReader;
import dev.twister.world.World;
import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class BenchmarkLineTest {
    private static final PictureSize SIZE = new PictureSize(5, 3);

    @TempDir
    private Path folder;

    private final StringWriter out = new StringWriter();
    private final StringWriter err = new StringWriter();
    private final BenchmarkPlan plan =
            BenchmarkPlan.bySize(List.of("sequential", "parallel"), List.of(new Setting(SIZE, 1, 0)), 0, 1, 10);

    @Test
    void anEndBeforeAnythingIsMeasuredSaysWhere() {
        try (BenchmarkLine line = line()) {
            line.begins("parallel", SIZE, 1);
            line.giveUp();
        }

        assertThat(err.toString()).contains("ended at parallel 5x3", "nothing was measured");
        assertThat(out.toString()).isEmpty();
        assertThat(folder).isEmptyDirectory();
    }

    @Test
    void anEndAfterThatLosesNothing() throws IOException {
        Files.writeString(folder.resolve("report.json"), "older");
        try (BenchmarkLine line = line()) {
            Benchmark.run(Engines::open, plan, "benchmark", world(), Optional.empty(), line);
            line.begins("tornado:0:0", SIZE, 1);
            line.giveUp();
        }

        assertThat(err.toString()).contains("ended at tornado:0:0 5x3");
        assertThat(out.toString()).containsPattern("sequential .* 5x3 ").containsPattern("parallel .* 5x3 ");
        Path json = folder.resolve("report-unfinished.json");
        Path csv = folder.resolve("report-unfinished.csv");
        assertThat(err.toString()).contains("is in " + json + " and " + csv);
        assertThat(json)
                .content()
                .contains(
                        "\"engine\" : \"parallel\"", "\"engine\" : \"tornado:0:0\"", "ended at", "\"passed\" : false");
        assertThat(csv).content().contains("sequential,", "parallel,", "ended at");
        assertThat(folder.resolve("report.json")).hasContent("older");
        assertThat(folder.resolve("report.csv")).doesNotExist();
    }

    @Test
    void anEndTellsOfTheEnginesThatHadFailedByThen() {
        try (BenchmarkLine line = line()) {
            Benchmark.run(BenchmarkLineTest::openButParallel, plan, "benchmark", world(), Optional.empty(), line);
            line.begins("tornado:0:0", SIZE, 1);
            line.giveUp();
        }

        assertThat(out.toString()).contains("FAILED: parallel: out of order", "FAILED: tornado:0:0: ended at");
        assertThat(folder.resolve("report-unfinished.json")).content().contains("out of order");
    }

    private static Engine openButParallel(String id) {
        if (id.equals("parallel")) {
            throw new EngineException("out of order");
        }
        return Engines.open(id);
    }

    @Test
    void whatIsMeasuredIsKeptAsItComesAndNotAfterTheEnd() throws IOException {
        Path json = folder.resolve("report-unfinished.json");
        try (BenchmarkLine line = line()) {
            line.found(report());
            assertThat(json).exists();
            line.giveUp();
            Files.delete(json);

            line.found(report());
        }

        assertThat(json).doesNotExist();
    }

    @Test
    void aFinishedReportReplacesWhatAStoppedOneLeft() throws IOException {
        ReportFiles files = files();
        BenchmarkReport report = report();
        files.writeUnfinished(report);
        assertThat(folder.resolve("report-unfinished.csv")).exists();

        files.write(report);

        assertThat(folder.resolve("report.json")).exists();
        assertThat(folder.resolve("report.csv")).exists();
        assertThat(folder.resolve("report-unfinished.json")).doesNotExist();
        assertThat(folder.resolve("report-unfinished.csv")).doesNotExist();
    }

    @Test
    void whatCannotBeWrittenIsSaid() throws IOException {
        Path gone = Files.createDirectory(folder.resolve("gone"));
        ReportFiles files = new ReportFiles(Optional.of(gone.resolve("report")), Optional.empty());
        Files.delete(gone);

        assertThat(files.writeUnfinished(report())).contains("no file could be written", "there is no folder");
    }

    @Test
    void nothingGoesBesideADevice() throws IOException {
        Path device = Path.of("/dev/null");
        assumeTrue(Files.exists(device));
        ReportFiles files = new ReportFiles(Optional.of(device), Optional.empty());

        assertThat(files.writeUnfinished(report())).isEqualTo("this was measured:");
        assertThat(Path.of("/dev/null-unfinished")).doesNotExist();
    }

    @Test
    void anEndInTimeSaysNothing() {
        try (BenchmarkLine line = line()) {
            Benchmark.run(Engines::open, plan, "benchmark", world(), Optional.empty(), line);
        }

        assertThat(err.toString()).isEmpty();
        assertThat(out.toString()).isEmpty();
    }

    private BenchmarkLine line() {
        return new BenchmarkLine(new PrintWriter(out), new PrintWriter(err), plan, 0, files());
    }

    private ReportFiles files() {
        return new ReportFiles(Optional.of(folder.resolve("report.json")), Optional.of(folder.resolve("report.csv")));
    }

    private BenchmarkReport report() {
        return new BenchmarkReport(
                MachineInfo.ofThisMachine(), plan, "benchmark", List.of(), List.of(), Map.of(), false);
    }

    private static World world() {
        Scene scene = SceneReader.read(SceneFiles.find("benchmark"));
        return World.of(scene, SkyboxReader.read(scene.sky().file()));
    }
}
