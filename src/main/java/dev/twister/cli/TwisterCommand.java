package dev.twister.cli;

import picocli.AutoComplete;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.ScopeType;
import picocli.CommandLine.Spec;

/** {@code twister} itself: shows what there is. */
@Command(
        name = "twister",
        description = "A real-time ray tracer written entirely in Java.",
        mixinStandardHelpOptions = true,
        versionProvider = VersionProvider.class,
        scope = ScopeType.INHERIT,
        subcommands = {
            RenderCommand.class,
            BenchmarkCommand.class,
            DevicesCommand.class,
            SkyCommand.class,
            SceneCommand.class,
            AutoComplete.GenerateCompletion.class
        })
final class TwisterCommand implements Runnable {
    @Spec
    private CommandSpec spec;

    @Override
    public void run() {
        spec.commandLine().usage(spec.commandLine().getOut());
    }
}
