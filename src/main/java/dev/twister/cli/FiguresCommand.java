package dev.twister.cli;

import dev.twister.bench.FiguresPage;
import dev.twister.bench.PaperFigures;
import dev.twister.bench.RenderedFigure;
import dev.twister.engine.EngineException;
import dev.twister.engine.Engines;
import dev.twister.engine.JvmEngines;
import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.io.Writer;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.Callable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;

/** {@code twister figures}: the paper's rendered figures in one page. */
@Command(
        name = "figures",
        description = "Renders the figures of the paper into one HTML page, each with its equation and the command that"
                + " makes it.",
        footer = {"", "Examples:", "  twister figures", "  twister figures -o figures.html --engine vector"})
final class FiguresCommand implements Callable<Integer> {
    @Spec
    private CommandSpec spec;

    @Option(
            names = {"-o", "--output"},
            paramLabel = "FILE",
            defaultValue = "figures.html",
            description = "The page (default: ${DEFAULT-VALUE}).")
    private Path output;

    @Option(
            names = "--engine",
            paramLabel = "ENGINE",
            completionCandidates = Completions.OfEngine.class,
            defaultValue = JvmEngines.PARALLEL,
            description = "The engine that renders (default: ${DEFAULT-VALUE}).")
    private String engineId;

    @Override
    public Integer call() throws IOException {
        Engines.offer(engineId).check();
        OutputFile.check("--output", output);
        List<RenderedFigure> figures = render(engineId);
        FiguresPage.write(figures, output);
        spec.commandLine()
                .getOut()
                .println(output + ": " + figures.size() + " figures, "
                        + figures.stream()
                                .mapToInt(figure -> figure.pictures().size())
                                .sum()
                        + " pictures");
        return Main.OK;
    }

    /** The paper's figures, made by the commands that the page shows. */
    static List<RenderedFigure> render(String engineId) throws IOException {
        return PaperFigures.render(FiguresCommand::run, Home.folder(), engineId);
    }

    private static void run(Writer out, List<String> arguments) {
        StringWriter err = new StringWriter();
        int exitCode =
                Main.run(new PrintWriter(out, true), new PrintWriter(err, true), arguments.toArray(String[]::new));
        if (exitCode != Main.OK) {
            String message = err.toString().strip().replaceFirst("^twister: ", "");
            throw exitCode == Main.BAD_INPUT ? new BadInputException(message) : new EngineException(message);
        }
    }
}
