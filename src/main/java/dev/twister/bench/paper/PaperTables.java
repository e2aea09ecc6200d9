package dev.twister.bench.paper;

import dev.twister.bench.PublishedFigures;
import dev.twister.bench.benchmark.BenchmarkPlan;
import dev.twister.bench.benchmark.BenchmarkReport;
import dev.twister.bench.benchmark.MachineInfo;
import dev.twister.bench.benchmark.PaperFigure;
import dev.twister.bench.benchmark.Setting;
import dev.twister.bench.page.HtmlText;
import dev.twister.bench.page.HtmlText.Cell;
import dev.twister.engine.JvmEngines;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Function;
import java.util.stream.Stream;

/** The tables on the evaluation's page. */
final class PaperTables {
    private static final double GIBIBYTE = 1 << 30;
    private static final String NONE = "–";
    private static final String THEIRS = "theirs";
    private static final String BEST = "best";

    private PaperTables() {}

    static String machine(BenchmarkReport report) {
        MachineInfo machine = report.machine();
        List<List<Cell>> rows = new ArrayList<>();
        rows.add(fact("processor", machine.processor() + ", " + machine.cores() + " cores"));
        rows.add(fact("memory", String.format(Locale.ROOT, "%.1f GiB", machine.memoryBytes() / GIBIBYTE)));
        rows.add(fact("operating system", machine.operatingSystem()));
        rows.add(fact("JDK", machine.jdk() + ", " + machine.vendor() + ", " + machine.jit()));
        rows.add(fact("Twister", machine.twister()));
        rows.add(fact("TornadoVM", machine.tornadoVm().orElse("not here")));
        report.engines()
                .forEach(engine -> report.measurements().stream()
                        .filter(measurement -> measurement.engine().equals(engine))
                        .findFirst()
                        .ifPresent(first -> rows.add(fact("engine " + engine, first.device()))));
        return HtmlText.table("facts", List.of(), rows);
    }

    static String parameters(BenchmarkReport report) {
        BenchmarkPlan plan = report.plan();
        return HtmlText.table(
                "facts",
                List.of(),
                List.of(
                        fact("scene", report.scene()),
                        fact(
                                "frames",
                                "up to " + plan.frames() + " measured after up to " + plan.warmupFrames()
                                        + " to warm up, for at most "
                                        + PlotLook.number(plan.maxSeconds())
                                        + " s an engine and setting; one of each in any case. Before an engine's"
                                        + " first setting small pictures until they get no faster"),
                        fact(
                                "time of a frame",
                                "from the call to the pixels in Java's memory, copies included; "
                                        + "frames per second are 1 over the mean"),
                        fact(
                                "pictures",
                                report.passed()
                                        ? "every engine drew " + BenchmarkPlan.REFERENCE
                                                + "'s, within the tolerance, at every setting"
                                        : "not all are " + BenchmarkPlan.REFERENCE + "'s; see below")));
    }

    static String sizes(BenchmarkReport report) {
        List<Cell> titles = new ArrayList<>(titles(report.engines()));
        titles.add(new Cell(PublishedFigures.DEVICE + ", the paper's figure", THEIRS));
        return HtmlText.table(
                "",
                titles,
                report.plan().settings(PaperFigure.SIZES).stream()
                        .map(setting -> Stream.concat(
                                        row(
                                                setting.size().name(),
                                                report.engines(),
                                                engine -> report.fps(engine, setting))
                                                .stream(),
                                        Stream.of(new Cell(shown(PublishedFigures.fps(setting.size())), THEIRS)))
                                .toList())
                        .toList());
    }

    static String fps(BenchmarkReport report, PaperFigure figure, Function<Setting, String> name) {
        return HtmlText.table(
                "",
                titles(report.engines()),
                report.plan().settings(figure).stream()
                        .map(setting ->
                                row(name.apply(setting), report.engines(), engine -> report.fps(engine, setting)))
                        .toList());
    }

    /** One row per baseline and size. */
    static String speedup(BenchmarkReport report) {
        List<List<Cell>> rows = new ArrayList<>();
        for (String baseline : List.of(JvmEngines.SEQUENTIAL, JvmEngines.PARALLEL)) {
            for (Setting setting : report.plan().settings(PaperFigure.SPEEDUP)) {
                rows.add(row(
                        "over " + baseline + ", " + setting.size().name(),
                        report.engines(),
                        engine -> report.find(engine, setting)
                                .flatMap(measurement -> report.speedupOver(baseline, measurement))));
            }
        }
        List<Cell> published = new ArrayList<>();
        published.add(new Cell(
                "over parallel streams, the paper's largest: up to "
                        + PlotLook.number(PublishedFigures.LARGEST_SPEEDUP_OVER_PARALLEL),
                THEIRS));
        report.engines().forEach(_ -> published.add(new Cell("", THEIRS)));
        rows.add(published);
        return HtmlText.table("", titles(report.engines()), rows);
    }

    private static List<Cell> titles(List<String> engines) {
        return Stream.concat(Stream.of(""), engines.stream()).map(Cell::of).toList();
    }

    private static List<Cell> row(String name, List<String> engines, Function<String, Optional<Double>> value) {
        double most = engines.stream()
                .flatMap(engine -> value.apply(engine).stream())
                .mapToDouble(Double::doubleValue)
                .max()
                .orElse(0);
        List<Cell> cells = new ArrayList<>(List.of(Cell.of(name)));
        for (String engine : engines) {
            Optional<Double> number = value.apply(engine);
            cells.add(new Cell(shown(number), number.isPresent() && number.get() == most ? BEST : ""));
        }
        return cells;
    }

    private static String shown(Optional<Double> number) {
        return number.map(PlotLook::number).orElse(NONE);
    }

    private static List<Cell> fact(String name, String value) {
        return List.of(Cell.of(name), Cell.of(value));
    }
}
