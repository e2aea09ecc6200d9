package dev.twister.bench.benchmark;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import dev.twister.bench.GreedyEngine;
import dev.twister.bench.TestWorld;
import dev.twister.bench.paper.PaperFolder;
import dev.twister.bench.paper.PaperPlan;
import dev.twister.bench.report.CsvReport;
import dev.twister.bench.report.JsonReport;
import dev.twister.engine.Engine;
import dev.twister.engine.EngineException;
import dev.twister.engine.FakeEngine;
import dev.twister.image.FrameTimes;
import dev.twister.image.PictureSize;
import java.io.IOException;
import java.io.Reader;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.stream.Stream;
import javax.xml.parsers.DocumentBuilderFactory;
import org.apache.commons.csv.CSVFormat;
import org.apache.commons.csv.CSVRecord;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

class PaperBenchmarkTest {
    private static final int GRAY = 0xff808080;
    private static final List<PictureSize> SIZES = List.of(new PictureSize(8, 4), new PictureSize(12, 6));
    private static final BenchmarkPlan PLAN = PaperPlan.of(
            List.of("sequential", "parallel", "<fast>", "broken"), SIZES, List.of(1, 200), List.of(1, 2, 3));
    private static final BenchmarkReport REPORT = run(PLAN);

    @TempDir
    private Path folder;

    @Test
    void saysWhyItsFolderCannotBeMade() throws IOException {
        Path file = Files.writeString(folder.resolve("file"), "in the way");
        Path inside = file.resolve("report");
        assertThatThrownBy(() -> PaperFolder.make(inside))
                .isInstanceOf(IOException.class)
                .hasMessageStartingWith("cannot make the folder " + inside + ": ")
                .message()
                .doesNotContain("Exception");
    }

    @Test
    void settingsAreThePapersEachOnce() {
        BenchmarkPlan full = PaperPlan.full(List.of("sequential"));

        assertThat(full.settings(PaperFigure.SIZES))
                .extracting(Setting::toString)
                .containsExactly(
                        "1280x720, 1 shadow sample, 1 bounce",
                        "1920x1080, 1 shadow sample, 1 bounce",
                        "3840x2160, 1 shadow sample, 1 bounce");
        assertThat(full.settings(PaperFigure.SHADOW_SAMPLES))
                .extracting(Setting::shadowSamples)
                .startsWith(1)
                .endsWith(400);
        assertThat(full.settings(PaperFigure.BOUNCES))
                .allMatch(setting -> setting.shadowSamples() == 200)
                .extracting(Setting::bounces)
                .containsExactly(1, 2, 3, 4, 5, 6);
        assertThat(full.settings(PaperFigure.SPEEDUP))
                .allMatch(setting -> setting.shadowSamples() == 200 && setting.bounces() == 3)
                .hasSize(3);
        assertThat(full.settings()).doesNotHaveDuplicates().hasSize(15);
    }

    @Test
    void quickStaysWithinItsMinutesHoweverManyEngines() {
        for (int engines : List.of(1, 4, 40)) {
            BenchmarkPlan quick = PaperPlan.quick(Stream.iterate(1, i -> i + 1)
                    .limit(engines)
                    .map(i -> "e" + i)
                    .toList());
            assertThat(quick.maxSeconds() * engines * quick.settings().size()).isLessThanOrEqualTo(361);
        }
    }

    @Test
    void measuresEveryEngineAtEverySettingOnce() {
        assertThat(REPORT.measurements()).hasSize(3 * PLAN.settings().size());
        assertThat(REPORT.failures()).containsExactly(new EngineFailure("broken", "out of order"));
        Measurement fast = REPORT.find("<fast>", new Setting(new PictureSize(12, 6), 200, 3))
                .orElseThrow();
        assertThat(REPORT.speedupOver("sequential", fast)).contains(400.0);
        assertThat(REPORT.speedupOver("parallel", fast)).contains(200.0);
        assertThat(REPORT.pictures()).hasSize(2);
    }

    @Test
    void anEngineThatBecomesAnotherIsMeasuredUnderItsName() {
        BenchmarkPlan plan = PaperPlan.of(List.of("becomes parallel", "parallel"), SIZES, List.of(1), List.of(1));

        BenchmarkReport report = run(plan);

        assertThat(report.engines()).containsExactly("becomes parallel", "parallel");
        assertThat(report.measurements().getFirst().device()).startsWith("parallel: ");
    }

    @Test
    void anEngineThatNeedsTooMuchMemoryDoesNotStopTheOthers() {
        BenchmarkPlan plan = PaperPlan.of(List.of("greedy", "parallel"), SIZES, List.of(1), List.of(1));
        List<BenchmarkReport> reports = new ArrayList<>();

        BenchmarkReport report = run(plan, reports::add);

        assertThat(report.failures()).containsExactly(new EngineFailure("greedy", EngineFailure.outOfMemory()));
        assertThat(report.engines()).containsExactly("greedy", "parallel");
        assertThat(reports.get(1).failures()).isEqualTo(report.failures());
    }

    @Test
    void jsonHasTheFigures() throws IOException {
        write(REPORT);

        JsonNode json = JsonMapper.builder().build().readTree(Files.readString(folder.resolve("paper.json")));
        assertThat(json.at("/figures/sizes").size()).isEqualTo(6);
        assertThat(json.at("/figures/shadow-samples").size()).isEqualTo(6);
        assertThat(json.at("/figures/bounces").size()).isEqualTo(9);
        assertThat(json.at("/figures/speed-up").size()).isEqualTo(6);
        assertThat(json.at("/figures/speed-up/2/engine").asString()).isEqualTo("<fast>");
        assertThat(json.at("/figures/speed-up/2/speedupOverParallel").asDouble())
                .isEqualTo(200);
        assertThat(json.at("/published/largestSpeedupOverParallel").asDouble()).isEqualTo(796);
        assertThat(json.at("/machine/cores").asInt()).isPositive();
        assertThat(json.at("/parameters/scene").asString()).isEqualTo("test");
        assertThat(json.at("/failures/0/message").asString()).isEqualTo("out of order");
        assertThat(json.at("/finished").asBoolean()).isTrue();
        assertThat(json.at("/passed").asBoolean()).isFalse();
    }

    @Test
    void whatIsMeasuredSoFarIsToldEachTime() {
        List<BenchmarkReport> reports = new ArrayList<>();
        run(PLAN, reports::add);

        int measurements = 3 * PLAN.settings().size();
        assertThat(reports).hasSize(measurements + 1).noneMatch(BenchmarkReport::finished);
        assertThat(reports.getFirst().measurements()).hasSize(1);
        assertThat(reports.get(measurements - 1).measurements()).hasSize(measurements);
        assertThat(reports.getLast().failures()).hasSize(1);
        assertThat(REPORT.finished()).isTrue();
    }

    @Test
    void unfinishedNumbersSayThatTheyAre() throws IOException {
        List<BenchmarkReport> reports = new ArrayList<>();
        run(PLAN, reports::add);

        write(reports.getFirst());

        JsonNode unfinished = JsonMapper.builder().build().readTree(Files.readString(folder.resolve("paper.json")));
        assertThat(unfinished.at("/finished").asBoolean(true)).isFalse();
        assertThat(unfinished.at("/passed").asBoolean(true)).isFalse();
        assertThat(unfinished.at("/figures/sizes").size()).isEqualTo(1);
        assertThat(Files.readString(folder.resolve("paper.csv"))).contains(",false");
    }

    @Test
    void csvHasALineForEachFigureSettingAndEngine() throws IOException {
        write(REPORT);

        try (Reader reader = Files.newBufferedReader(folder.resolve("paper.csv"))) {
            List<CSVRecord> records = CSVFormat.RFC4180
                    .builder()
                    .setHeader()
                    .setSkipHeaderRecord(true)
                    .get()
                    .parse(reader)
                    .getRecords();
            assertThat(records).hasSize(6 + 6 + 9 + 6 + 1);
            CSVRecord first = records.getFirst();
            assertThat(first.get("figure")).isEqualTo("sizes");
            assertThat(first.get("engine")).isEqualTo("sequential");
            assertThat(first.get("width")).isEqualTo("8");
            assertThat(first.get("shadowSamples")).isEqualTo("1");
            assertThat(first.get("msMean")).isEqualTo("8.000000");
            assertThat(first.get("scene")).isEqualTo("test");
            assertThat(first.get("finished")).isEqualTo("true");
            assertThat(records.getLast().get("failure")).isEqualTo("out of order");
        }
    }

    @Test
    void pageHoldsEverythingAndLeadsNowhere() throws IOException {
        String page = Files.readString(write(REPORT));

        assertThat(page)
                .contains("&lt;fast&gt;", "broken: out of order")
                .contains("796", "RTX 2060", "the paper's figure")
                .contains(REPORT.machine().jdk())
                .contains("data:image/png;base64,", "data:image/svg+xml;base64,")
                .doesNotContain("<fast>", "<script", "<link", "src=\"http");
        assertThat(page.split("<img", -1)).hasSize(1 + 5 + 2);
    }

    @Test
    void publishedFiguresStandBesideTheirSizes() throws IOException {
        BenchmarkPlan plan = PaperPlan.of(List.of("sequential"), List.of(PictureSize.HD), List.of(1), List.of(1));

        String page = Files.readString(write(run(plan)));

        assertThat(page).contains("<td class=\"theirs\">234</td>").contains("the paper reports 234 on an RTX 2060");
    }

    @Test
    void plotsAreDocumentsOfTheirOwn() throws Exception {
        write(REPORT);

        try (Stream<Path> files = Files.list(folder)) {
            List<Path> plots =
                    files.filter(file -> file.toString().endsWith(".svg")).toList();
            assertThat(plots).hasSize(5);
            for (Path plot : plots) {
                assertThat(DocumentBuilderFactory.newDefaultNSInstance()
                                .newDocumentBuilder()
                                .parse(plot.toFile())
                                .getDocumentElement()
                                .getNamespaceURI())
                        .isEqualTo("http://www.w3.org/2000/svg");
            }
        }
    }

    @Test
    void noPlotOfAnOlderReportStays() throws IOException {
        write(REPORT);
        Path own = Files.writeString(folder.resolve("my-own.svg"), "kept");
        BenchmarkPlan plan = PaperPlan.of(List.of("sequential", "<fast>"), SIZES, List.of(1, 200), List.of(1));

        write(run(plan));

        assertThat(folder.resolve("speed-up-over-parallel.svg")).doesNotExist();
        assertThat(folder.resolve("speed-up-over-sequential.svg")).exists();
        assertThat(own).exists();
    }

    @Test
    void withoutAnyMeasurementThereIsStillAPage() throws IOException {
        BenchmarkPlan plan = PaperPlan.of(List.of("broken"), SIZES, List.of(1), List.of(1));

        assertThat(write(run(plan))).isRegularFile().content().contains("out of order");
    }

    private static BenchmarkReport run(BenchmarkPlan plan) {
        return run(plan, _ -> {});
    }

    private static BenchmarkReport run(BenchmarkPlan plan, Consumer<BenchmarkReport> soFar) {
        return Benchmark.run(
                PaperBenchmarkTest::open, plan, "test", TestWorld.create(), Optional.empty(), new BenchmarkProgress() {
                    @Override
                    public void found(BenchmarkReport report) {
                        soFar.accept(report);
                    }
                });
    }

    private Path write(BenchmarkReport report) throws IOException {
        JsonReport.write(report, folder.resolve(PaperFolder.JSON));
        CsvReport.write(report, folder.resolve(PaperFolder.CSV));
        return PaperFolder.write(report, folder, true, List.of());
    }

    private static Engine open(String id) {
        return switch (id) {
            case "sequential" -> new FakeEngine(id, GRAY, FrameTimes.onJvm(8_000_000));
            case "parallel", "becomes parallel" -> new FakeEngine("parallel", GRAY, FrameTimes.onJvm(4_000_000));
            case "<fast>" -> new FakeEngine(id, GRAY, FrameTimes.onJvm(20_000));
            case "greedy" -> new GreedyEngine(open("sequential"), id, 12);
            default -> throw new EngineException("out of order");
        };
    }
}
