package dev.twister.cli;

import java.util.concurrent.Callable;
import picocli.AutoComplete;
import picocli.CommandLine.Command;
import picocli.CommandLine.ScopeType;

/** {@code twister} itself: opens the window. */
@Command(
        name = "twister",
        description = "A real-time ray tracer written entirely in Java.",
        mixinStandardHelpOptions = true,
        versionProvider = VersionProvider.class,
        scope = ScopeType.INHERIT,
        subcommands = {
            GuiCommand.class,
            RenderCommand.class,
            SimulateCommand.class,
            ExplainCommand.class,
            FiguresCommand.class,
            JoinCommand.class,
            DenoiseCommand.class,
            FilmCommand.class,
            BenchmarkCommand.class,
            DevicesCommand.class,
            SkyCommand.class,
            SceneCommand.class,
            ViewCommand.class,
            AutoComplete.GenerateCompletion.class
        })
final class TwisterCommand implements Callable<Integer> {
    private final CommandRunner runner;

    /** @param runner runs the command lines of which commands consist */
    TwisterCommand(CommandRunner runner) {
        this.runner = runner;
    }

    CommandRunner runner() {
        return runner;
    }

    @Override
    public Integer call() {
        return new GuiCommand().call();
    }
}
