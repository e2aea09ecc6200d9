package dev.twister.cli.command;

import dev.twister.bench.figures.PaperFigures;
import dev.twister.bench.figures.RenderedFigure;
import dev.twister.bench.page.FiguresPage;
import dev.twister.cli.file.ExitCode;
import dev.twister.cli.file.Home;
import dev.twister.cli.file.OutputFile;
import dev.twister.cli.option.Completions;
import dev.twister.engine.Engines;
import dev.twister.engine.JvmEngines;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.Callable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParentCommand;
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

    @ParentCommand
    private TwisterCommand twister;

    @Option(
            names = {"-o", "--output"},
            paramLabel = "FILE",
            defaultValue = "figures.html",
            description = "The page (default: ${DEFAULT-VALUE}); - for standard output.")
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
        OutputFile.checkText("--output", output);
        List<RenderedFigure> figures = PaperFigures.render(twister.runner()::require, Home.folder(), engineId);
        FiguresPage.write(figures, output);
        OutputFile.notes(spec.commandLine(), output)
                .println(OutputFile.name(output) + ": " + figures.size() + " figures, "
                        + figures.stream()
                                .mapToInt(figure -> figure.pictures().size())
                                .sum()
                        + " pictures");
        return ExitCode.OK;
    }
}
