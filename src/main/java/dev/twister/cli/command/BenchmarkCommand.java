package dev.twister.cli.command;

import dev.twister.bench.benchmark.Benchmark;
import dev.twister.bench.benchmark.BenchmarkPlan;
import dev.twister.bench.benchmark.BenchmarkReport;
import dev.twister.bench.benchmark.Jit;
import dev.twister.bench.benchmark.MotionPlan;
import dev.twister.bench.benchmark.Setting;
import dev.twister.bench.figures.PaperFigures;
import dev.twister.bench.paper.PaperFolder;
import dev.twister.bench.paper.PaperPlan;
import dev.twister.bench.report.JitReport;
import dev.twister.bench.report.JitRuns;
import dev.twister.bench.report.ReportComparison;
import dev.twister.bench.report.ReportTable;
import dev.twister.bench.results.ResultsPage;
import dev.twister.cli.file.BadInputException;
import dev.twister.cli.file.CommonOptions;
import dev.twister.cli.file.ExitCode;
import dev.twister.cli.file.Home;
import dev.twister.cli.file.OutputFile;
import dev.twister.cli.file.ReportFiles;
import dev.twister.cli.file.SceneFiles;
import dev.twister.cli.file.SkyFiles;
import dev.twister.cli.option.Completions;
import dev.twister.cli.option.EngineNames;
import dev.twister.cli.option.MotionOptions;
import dev.twister.cli.option.PictureSizeConverter;
import dev.twister.cli.option.Ranges;
import dev.twister.cli.option.ShadingOptions;
import dev.twister.cli.progress.BenchmarkLine;
import dev.twister.engine.EngineOffer;
import dev.twister.engine.JvmEngines;
import dev.twister.image.PictureSize;
import dev.twister.physics.Simulation;
import dev.twister.render.SceneInputs;
import dev.twister.scene.Integrator;
import dev.twister.scene.Rendering;
import dev.twister.scene.Scene;
import dev.twister.scene.select.VisibleBodies;
import dev.twister.world.World;
import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.Callable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.ParentCommand;
import picocli.CommandLine.ParseResult;
import picocli.CommandLine.Spec;

/** {@code twister benchmark}: engines by sizes, and whether they draw the same picture. */
@Command(
        name = "benchmark",
        description = "Measures the frame times of the engines and compares their pictures with sequential's.",
        footer = {
            "",
            "Examples:",
            "  twister benchmark",
            "  twister benchmark --quick --json results.json --csv results.csv",
            "  twister benchmark spheres-100 --engine parallel --engine tornado --size 1080p --size 4k",
            "  twister benchmark pour-100000 --physics --start 30 --engine vector --size 720p",
            "  twister benchmark weekend --integrator path --size 1200x675",
            "  twister benchmark --paper --quick --output my-machine",
            "  twister benchmark --quick --engine vector --engine parallel --jit c2,graal",
            "  twister benchmark --compare before.json after.json --within 3",
            "  twister benchmark --page site results.jsonl",
            "",
            "Exit code 1: an engine failed, its picture differs, with --compare it became slower, or with"
                    + " --page a result was refused."
        })
final class BenchmarkCommand implements Callable<Integer> {
    private static final int SHADOW_SAMPLES = 200;
    private static final int BOUNCES = 3;
    private static final int CLASSIC_SHADOW_SAMPLES = 1;
    private static final int CLASSIC_BOUNCES = 1;

    /** What the compiler needs for the fastest engine, whose frames are short. */
    private static final int WARMUP_FRAMES = 100;

    /** Pictures of path tracing differ in noise alone. */
    private static final int PATHS_PER_PIXEL = 1;

    private static final String PAPER_FOLDER = "twister-paper";
    private static final Set<String> COMPARING =
            Set.of("--compare", "--within", CommonOptions.QUIET, CommonOptions.VERBOSE);
    private static final Set<String> SHOWING = Set.of("--page", CommonOptions.QUIET, CommonOptions.VERBOSE);
    private static final double SLOWER_PERCENT = 5;
    private static final double MAX_PERCENT = 1000;
    private static final String MAIN_CLASS = "dev.twister.cli.Main";
    private static final int MAX_FRAMES = 100_000;
    private static final double MIN_SECONDS = 0.001;
    private static final double MAX_SECONDS = 86_400;

    @Spec
    private CommandSpec spec;

    @ParentCommand
    private TwisterCommand twister;

    @Parameters(
            paramLabel = "SCENE",
            completionCandidates = Completions.OfScene.class,
            arity = "0..1",
            defaultValue = "benchmark",
            description =
                    "A scene file, the name of a shipped scene, or - for standard input (default: ${DEFAULT-VALUE}).")
    private String sceneName;

    @Option(
            names = "--engine",
            paramLabel = "ENGINE",
            completionCandidates = Completions.OfEngine.class,
            description = "Repeatable. Default: every available engine except auto.")
    private List<String> engines = new ArrayList<>();

    @Option(
            names = "--size",
            paramLabel = "SIZE",
            converter = PictureSizeConverter.class,
            description = "Such as 1280x720 or 720p. Repeatable. Default: 720p, 1080p and 4k.")
    private List<PictureSize> sizes = new ArrayList<>();

    @Mixin
    private ShadingOptions shading;

    @Option(
            names = "--samples",
            paramLabel = "N",
            description = "Paths per pixel with --integrator path (default: " + PATHS_PER_PIXEL + ").")
    private Optional<Integer> samples = Optional.empty();

    @Option(
            names = "--classic",
            description = "One shadow sample and one bounce instead of " + SHADOW_SAMPLES + " and " + BOUNCES + ".")
    private boolean classic;

    @Option(
            names = "--quick",
            description = "Take minutes on a small machine: 720p and 1080p, 5 frames, at most 10 seconds each.")
    private boolean quick;

    @Option(
            names = "--warmup",
            paramLabel = "N",
            description = "Warm-up frames per size (default: " + WARMUP_FRAMES + "); small frames run first until times"
                    + " settle. 0 disables both.")
    private Optional<Integer> warmup = Optional.empty();

    @Option(names = "--frames", paramLabel = "N", description = "Measured frames per size (default: 10).")
    private Optional<Integer> frames = Optional.empty();

    @Option(
            names = "--max-seconds",
            paramLabel = "SECONDS",
            description =
                    "Time limit per engine and size, warm-up included (default: 30). The small frames before the first"
                            + " size have the same limit.")
    private Optional<Double> maxSeconds = Optional.empty();

    @Option(
            names = "--json",
            paramLabel = "FILE",
            description = "Also write the report as JSON; a .jsonl file gets it as a new line. - for standard output.")
    private Optional<Path> json = Optional.empty();

    @Option(names = "--csv", paramLabel = "FILE", description = "Also write the report as CSV; - for standard output.")
    private Optional<Path> csv = Optional.empty();

    @Option(
            names = "--paper",
            description = "Repeat the paper's evaluation: plots, tables and pictures in one page; with --quick in at"
                    + " most ten minutes on two cores.")
    private boolean paper;

    @Option(
            names = {"-o", "--output"},
            paramLabel = "DIR",
            description = "The folder for --paper (default: " + PAPER_FOLDER + ").")
    private Optional<Path> output = Optional.empty();

    @Option(
            names = "--jit",
            paramLabel = "JIT",
            split = ",",
            description =
                    "Run once per compiler, each in a JVM of its own, and compare: ${COMPLETION-CANDIDATES}. graal"
                            + " needs GraalVM or a TornadoVM SDK. Default: this JVM's.")
    private List<Jit> jits = new ArrayList<>();

    @Option(
            names = "--compare",
            arity = "2",
            paramLabel = "FILE",
            description = "Compare two reports of --json, .json or .jsonl, instead of measuring: ratios of the median"
                    + " times with their uncertainty. Exit code 1: something became slower.")
    private List<Path> compared = List.of();

    @Option(
            names = "--within",
            paramLabel = "PERCENT",
            description = "With --compare: how much slower, beyond the uncertainty, counts as equal (default: 5).")
    private Optional<Double> within = Optional.empty();

    @Option(
            names = "--page",
            arity = "2..*",
            paramLabel = "DIR FILE...",
            hideParamSyntax = true,
            description = "Write a page of the results in reports of --json, .json or .jsonl, to a folder, instead of"
                    + " measuring. Results whose picture was not equal are refused.")
    private List<Path> shown = List.of();

    @Mixin
    private MotionOptions motion;

    @Override
    public Integer call() throws IOException {
        if (!compared.isEmpty()) {
            return compareReports();
        }
        if (!shown.isEmpty()) {
            return showReports();
        }
        if (within.isPresent()) {
            throw new BadInputException("--within requires --compare");
        }
        motion.check();
        if (!jits.isEmpty()) {
            return compareJits();
        }
        return paper ? evaluate() : compare();
    }

    private int compareReports() throws IOException {
        measuresNothing("--compare", "goes with --within alone", COMPARING);
        double percent = Ranges.check("--within", within.orElse(SLOWER_PERCENT), 0, MAX_PERCENT);
        ReportComparison comparison = ReportComparison.of(compared.getFirst(), compared.getLast(), percent);
        spec.commandLine().getOut().println(comparison.table());
        return comparison.passed() ? ExitCode.OK : ExitCode.FAILED;
    }

    private int showReports() throws IOException {
        measuresNothing("--page", "goes with no other option", SHOWING);
        Path folder = shown.getFirst();
        if (Files.exists(folder) && !Files.isDirectory(folder)) {
            throw new BadInputException("--page has " + folder + " first, but must have a folder there");
        }
        PaperFolder.make(folder);
        ResultsPage.Written written = ResultsPage.write(folder, shown.subList(1, shown.size()));
        PrintWriter out = spec.commandLine().getOut();
        out.println(written.page() + ": results of " + written.rows() + " engines");
        written.refused().forEach(line -> out.println("REFUSED: " + line));
        return written.refused().isEmpty() ? ExitCode.OK : ExitCode.FAILED;
    }

    private void measuresNothing(String option, String company, Set<String> allowed) {
        ParseResult given = spec.commandLine().getParseResult();
        boolean measures = !given.matchedPositionals().isEmpty()
                || given.matchedOptions().stream().anyMatch(other -> !allowed.contains(other.longestName()));
        if (measures) {
            throw new BadInputException(option + " measures nothing: it " + company);
        }
    }

    private int compareJits() throws IOException {
        if (paper || csv.isPresent()) {
            throw new BadInputException("--jit excludes --paper and --csv");
        }
        for (Jit jit : jits) {
            if (!jit.isHere()) {
                throw new BadInputException("--jit is " + jit.id() + ", but the JDK in "
                        + System.getProperty("java.home")
                        + " does not have it; set JAVA_HOME to a GraalVM, or install a TornadoVM SDK, which has Graal");
            }
        }
        ReportFiles files = new ReportFiles(json, Optional.empty());
        files.check();
        // An error in these should not come out once for each JVM.
        engineIds();
        Path file = SceneFiles.find(sceneName);
        if (file.equals(SceneFiles.STANDARD_INPUT)) {
            throw new BadInputException("--jit reads the scene several times; give a file instead of standard input");
        }
        files.checkKeeps(List.of(file));
        List<String> arguments = spec.commandLine().getParseResult().originalArgs();
        JitReport report =
                new JitRuns(MAIN_CLASS, arguments).run(jits.stream().distinct().toList());
        files.tables(spec.commandLine()).println(report.table());
        if (json.isPresent()) {
            report.write(json.get());
        }
        return report.passed() ? ExitCode.OK : ExitCode.FAILED;
    }

    private int evaluate() throws IOException {
        if (!sizes.isEmpty()
                || samples.isPresent()
                || shading.areGiven()
                || classic
                || json.isPresent()
                || csv.isPresent()
                || motion.isOn()) {
            throw new BadInputException("--paper has its own sizes, shadow samples, bounces and files: it goes with"
                    + " --engine, --quick, --warmup, --frames, --max-seconds and --output only");
        }
        List<String> ids = engineIds();
        BenchmarkPlan plan = limited(quick ? PaperPlan.quick(ids) : PaperPlan.full(ids));
        Scene scene = VisibleBodies.of(SceneFiles.read(SceneFiles.find(sceneName)));
        Path folder = output.orElse(Path.of(PAPER_FOLDER));
        if (Files.exists(folder) && !Files.isDirectory(folder)) {
            throw new BadInputException("--output is " + folder + ", but must be a folder");
        }
        PaperFolder.make(folder);
        OutputFile.check("--output", folder.resolve(PaperFolder.PAGE));
        ReportFiles files = new ReportFiles(
                Optional.of(folder.resolve(PaperFolder.JSON)), Optional.of(folder.resolve(PaperFolder.CSV)));
        BenchmarkReport report = run(plan, scene, files);
        files.write(report);
        PrintWriter out = spec.commandLine().getOut();
        out.println(PaperFolder.write(
                        report,
                        folder,
                        scene.rendering().srgb(),
                        PaperFigures.render(twister.runner()::require, Home.folder(), JvmEngines.PARALLEL))
                + ": "
                + report.engines().size() + " engines at " + plan.settings().size()
                + " settings; beside it JSON, CSV, plots and pictures");
        report.problems().forEach(problem -> out.println("FAILED: " + problem));
        return report.passed() ? ExitCode.OK : ExitCode.FAILED;
    }

    private int compare() throws IOException {
        if (output.isPresent()) {
            throw new BadInputException("--output is the folder of --paper; write a report with --json or --csv");
        }
        ReportFiles files = new ReportFiles(json, csv);
        files.check();
        Path file = SceneFiles.find(sceneName);
        Scene scene = VisibleBodies.of(SceneFiles.read(file));
        Rendering settings = shading.over(scene.rendering());
        BenchmarkPlan plan = limited(BenchmarkPlan.bySize(
                engineIds(),
                plannedSizes().stream().map(size -> setting(size, settings)).toList(),
                WARMUP_FRAMES,
                quick ? 5 : 10,
                quick ? 10 : 30));
        files.checkKeeps(SceneInputs.of(file, scene));
        BenchmarkReport report = run(plan, scene, files);
        files.tables(spec.commandLine()).println(ReportTable.of(report));
        files.write(report);
        return report.passed() ? ExitCode.OK : ExitCode.FAILED;
    }

    private Setting setting(PictureSize size, Rendering settings) {
        if (settings.integrator() == Integrator.PATH) {
            if (classic) {
                throw new BadInputException("--classic is for the integrator whitted, but the picture has path; use"
                        + " --bounces and --samples");
            }
            int paths = Ranges.check("--samples", samples.orElse(PATHS_PER_PIXEL), 1, Rendering.MAX_SAMPLES_PER_PIXEL);
            return new Setting(size, settings.shadowSamples(), settings.bounces(), Optional.of(paths));
        }
        if (samples.isPresent()) {
            throw new BadInputException(
                    "--samples is for the integrator path, but the picture has whitted; add" + " --integrator path");
        }
        Rendering shaded = shading.over(settings.withShadowSamples(classic ? CLASSIC_SHADOW_SAMPLES : SHADOW_SAMPLES)
                .withBounces(classic ? CLASSIC_BOUNCES : BOUNCES));
        return new Setting(size, shaded.shadowSamples(), shaded.bounces());
    }

    private BenchmarkReport run(BenchmarkPlan plan, Scene scene, ReportFiles files) {
        World world = SkyFiles.world(
                scene.withRendering(shading.over(scene.rendering())),
                spec.commandLine().getErr());
        Optional<MotionPlan> moving = motion.isOn()
                ? Optional.of(new MotionPlan(scene, motion.startSeconds(), motion.secondsPerFrame()))
                : Optional.empty();
        int stepsToStart = motion.isOn() ? Simulation.stepsIn(motion.startSeconds()) : 0;
        try (BenchmarkLine line = new BenchmarkLine(
                files.tables(spec.commandLine()), spec.commandLine().getErr(), plan, stepsToStart, files)) {
            return Benchmark.run(Benchmark::open, plan, sceneName, world, moving, line);
        }
    }

    private BenchmarkPlan limited(BenchmarkPlan usual) {
        return usual.within(
                Ranges.check("--warmup", warmup.orElse(usual.warmupFrames()), 0, MAX_FRAMES),
                Ranges.check("--frames", frames.orElse(usual.frames()), 1, MAX_FRAMES),
                Ranges.check("--max-seconds", maxSeconds.orElse(usual.maxSeconds()), MIN_SECONDS, MAX_SECONDS));
    }

    private List<PictureSize> plannedSizes() {
        if (!sizes.isEmpty()) {
            return sizes.stream().distinct().toList();
        }
        return quick
                ? List.of(PictureSize.HD, PictureSize.FULL_HD)
                : List.of(PictureSize.HD, PictureSize.FULL_HD, PictureSize.ULTRA_HD);
    }

    private List<String> engineIds() {
        return EngineNames.chosen(engines).stream()
                .filter(offer -> !engines.isEmpty() || offer.works())
                .map(EngineOffer::id)
                .toList();
    }
}
