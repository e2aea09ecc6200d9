package dev.twister.cli.command;

import dev.twister.bench.benchmark.Jit;
import dev.twister.bench.device.DeviceCheckPlan;
import dev.twister.cli.file.BadInputException;
import dev.twister.cli.file.ExitCode;
import dev.twister.cli.file.OutputFile;
import dev.twister.cli.option.Completions;
import dev.twister.cli.option.EngineNames;
import dev.twister.denoise.DenoiserOffer;
import dev.twister.denoise.Denoisers;
import dev.twister.engine.EngineOffer;
import dev.twister.engine.Engines;
import dev.twister.engine.auto.FastestEngine;
import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Path;
import java.time.Duration;
import java.time.LocalDate;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.concurrent.Callable;
import picocli.CommandLine;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;

/** {@code twister devices}: what can draw here, and what keeps the rest from it. */
@Command(
        name = "devices",
        description = "Lists engines and devices, and says what to install for those that do not work here.",
        footer = {
            "",
            "Examples:",
            "  twister devices",
            "  twister devices --measure",
            "  twister devices --check",
            "  twister devices --check --engine tornado:0:0 --json device.json",
            "",
            "Exit code 1: in a check, an engine failed or its picture differs."
        })
final class DevicesCommand implements Callable<Integer> {
    private static final double NANOS_PER_MILLI = 1e6;

    @Spec
    private CommandSpec spec;

    @Option(
            names = "--measure",
            description = "Measure again which engine is fastest, for 'auto'; waits until devices are ready.")
    private boolean measure;

    @Option(
            names = "--check",
            description = "Compare each engine's pictures of all shipped scenes with sequential's, measure it, and"
                    + " print a table in Markdown to paste into a report. Takes some minutes per engine"
                    + " on a small machine.")
    private boolean check;

    @Option(
            names = "--engine",
            paramLabel = "ENGINE",
            completionCandidates = Completions.OfEngine.class,
            description = "Repeatable; with --check. Default: every engine except auto.")
    private List<String> engines = new ArrayList<>();

    @Option(
            names = "--json",
            paramLabel = "FILE",
            description = "With --check: also write the results as JSON; - for standard output.")
    private Optional<Path> json = Optional.empty();

    @Override
    public Integer call() throws IOException {
        PrintWriter out = spec.commandLine().getOut();
        if (!check && (json.isPresent() || !engines.isEmpty())) {
            throw new BadInputException("--engine and --json require --check");
        }
        if (check && measure) {
            throw new BadInputException("--check and --measure exclude each other; give one of them");
        }
        if (check) {
            CommandLine command = spec.commandLine();
            PrintWriter table =
                    json.map(file -> OutputFile.notes(command, file)).orElse(out);
            DeviceChecking checking = new DeviceChecking(DeviceCheckPlan.USUAL, table, command.getErr());
            return checking.run(EngineNames.chosen(engines), json) ? ExitCode.OK : ExitCode.FAILED;
        }
        list(out);
        return ExitCode.OK;
    }

    private void list(PrintWriter out) {
        List<EngineOffer> offers = Engines.offers();
        FastestEngine fastest = FastestEngine.ofThisMachine();
        if (measure) {
            fastest.measurePatiently(offers).forEach(time -> printTime(out, time));
            out.println();
        }
        int idWidth =
                offers.stream().mapToInt(offer -> offer.id().length()).max().orElse(0);
        out.println("These engines work here:");
        offers.stream().filter(EngineOffer::works).forEach(offer -> print(out, offer, idWidth));
        out.println();
        out.println(autoLine(fastest.remembered(offers), fastest.day(offers)));
        jitLine(Jit.running()).ifPresent(out::println);
        if (offers.stream().anyMatch(offer -> !offer.works())) {
            out.println();
            out.println("These do not:");
            offers.stream().filter(offer -> !offer.works()).forEach(offer -> {
                print(out, offer, idWidth);
                out.println(" ".repeat(idWidth + 4) + offer.obstacle().orElseThrow());
            });
        }
        out.println();
        DenoiserOffer denoiser = Denoisers.offer();
        out.println(denoiser.obstacle()
                .map(obstacle -> "Pictures cannot be denoised here: " + obstacle + ".")
                .orElse("Pictures are denoised by " + denoiser.name() + "."));
    }

    private static void print(PrintWriter out, EngineOffer offer, int idWidth) {
        out.println("  " + offer.id() + " ".repeat(idWidth - offer.id().length()) + "  " + offer.device() + ": "
                + offer.description());
    }

    private static String autoLine(Optional<String> taken, Optional<LocalDate> day) {
        return taken.map(id -> "auto takes " + id + " here"
                        + day.map(measured -> ", measured on " + measured).orElse("") + ".")
                .orElse("auto has not been measured here yet; 'twister devices --measure' does that and says what it"
                        + " takes.");
    }

    static Optional<String> jitLine(Jit jit) {
        return jit == Jit.GRAAL
                ? Optional.of("Graal compiles here, with which vector is many times slower than with C2;"
                        + " -XX:-UseJVMCICompiler chooses C2.")
                : Optional.empty();
    }

    private static void printTime(PrintWriter out, FastestEngine.Time time) {
        out.println(time.engine() + ": "
                + time.frame().map(DevicesCommand::milliseconds).orElse("drew nothing in the time it had"));
    }

    private static String milliseconds(Duration frame) {
        return String.format(Locale.ROOT, "%.1f ms", frame.toNanos() / NANOS_PER_MILLI);
    }
}
