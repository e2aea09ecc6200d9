package dev.twister.cli;

import dev.twister.engine.EngineOffer;
import dev.twister.engine.Engines;
import dev.twister.engine.auto.FastestEngine;
import java.io.PrintWriter;
import java.time.Duration;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;

/** {@code twister devices}: what can draw here, and what keeps the rest from it. */
@Command(
        name = "devices",
        description = "Shows the engines and devices that work here, and for those that do not, what to install.",
        footer = {"", "Examples:", "  twister devices", "  twister devices --measure"})
final class DevicesCommand implements Runnable {
    private static final double NANOS_PER_MILLI = 1e6;

    @Spec
    private CommandSpec spec;

    @Option(
            names = "--measure",
            description = "Measure anew which engine 'auto' takes, and wait until devices are ready for it.")
    private boolean measure;

    @Override
    public void run() {
        PrintWriter out = spec.commandLine().getOut();
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
        out.println(autoLine(fastest.remembered(offers)));
        if (offers.stream().anyMatch(offer -> !offer.works())) {
            out.println();
            out.println("These do not:");
            offers.stream().filter(offer -> !offer.works()).forEach(offer -> {
                print(out, offer, idWidth);
                out.println(" ".repeat(idWidth + 4) + offer.obstacle().orElseThrow());
            });
        }
    }

    private static void print(PrintWriter out, EngineOffer offer, int idWidth) {
        out.println("  " + offer.id() + " ".repeat(idWidth - offer.id().length()) + "  " + offer.device() + ": "
                + offer.description());
    }

    private static String autoLine(Optional<String> taken) {
        return taken.map(id -> "auto takes " + id + " here.")
                .orElse(
                        "auto has not been measured here yet; 'twister devices --measure' does that and says what it takes.");
    }

    private static void printTime(PrintWriter out, FastestEngine.Time time) {
        out.println(time.engine() + ": "
                + time.frame().map(DevicesCommand::milliseconds).orElse("drew nothing in the time it had"));
    }

    private static String milliseconds(Duration frame) {
        return String.format(Locale.ROOT, "%.1f ms", frame.toNanos() / NANOS_PER_MILLI);
    }
}
