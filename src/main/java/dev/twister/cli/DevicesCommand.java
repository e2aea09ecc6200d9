package dev.twister.cli;

import dev.twister.engine.EngineOffer;
import dev.twister.engine.Engines;
import java.io.PrintWriter;
import java.util.List;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Spec;

/** {@code twister devices}: what can draw here, and what keeps the rest from it. */
@Command(
        name = "devices",
        description = "Shows the engines and devices that work here, and for those that do not, what to install.",
        footer = {"", "Example:", "  twister devices"})
final class DevicesCommand implements Runnable {
    @Spec
    private CommandSpec spec;

    @Override
    public void run() {
        PrintWriter out = spec.commandLine().getOut();
        List<EngineOffer> offers = Engines.offers();
        int idWidth =
                offers.stream().mapToInt(offer -> offer.id().length()).max().orElse(0);
        out.println("These engines work here:");
        offers.stream().filter(EngineOffer::works).forEach(offer -> print(out, offer, idWidth));
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
}
