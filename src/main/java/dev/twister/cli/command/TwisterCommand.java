package dev.twister.cli.command;

import dev.twister.cli.file.BadInputException;
import dev.twister.cli.file.CommonOptions;
import dev.twister.cli.file.ExitCode;
import dev.twister.cli.manual.ManPage;
import dev.twister.cli.manual.ShellCompletion;
import dev.twister.engine.EngineException;
import dev.twister.files.TwisterVersion;
import dev.twister.files.WholeFile;
import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.io.Writer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.Callable;
import picocli.AutoComplete;
import picocli.CommandLine;
import picocli.CommandLine.Command;
import picocli.CommandLine.IVersionProvider;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.ScopeType;
import picocli.CommandLine.Spec;

/** {@code twister} itself: opens the window. */
@Command(
        name = "twister",
        description = "A real-time ray tracer written entirely in Java.",
        mixinStandardHelpOptions = true,
        versionProvider = TwisterCommand.VersionProvider.class,
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
            AutoComplete.GenerateCompletion.class,
            TwisterCommand.PackageFilesCommand.class
        })
public final class TwisterCommand implements Callable<Integer> {
    private final CommandRunner runner;

    @Option(
            names = {"-q", CommonOptions.QUIET},
            scope = ScopeType.INHERIT,
            description = "Print results and errors alone: no progress, warnings or notes on what was written.")
    @SuppressWarnings("unused") // asked of the command line, see CommonOptions
    private boolean quiet;

    @Option(
            names = CommonOptions.VERBOSE,
            scope = ScopeType.INHERIT,
            description = "Print the version, the time and the memory of the run, and the stack trace of a failure.")
    @SuppressWarnings("unused")
    private boolean verbose;

    /** @param runner runs the command lines of which commands consist */
    public TwisterCommand(CommandRunner runner) {
        this.runner = runner;
    }

    CommandRunner runner() {
        return runner;
    }

    @Override
    public Integer call() throws IOException {
        return new GuiCommand().call();
    }

    /** {@code twister package-files}: what a package installs for {@code man} and for shells. */
    @Command(
            name = "package-files",
            hidden = true,
            description = "Writes the manual page, and the completion files of bash, zsh and fish.")
    static final class PackageFilesCommand implements Callable<Integer> {
        @Spec
        private CommandSpec spec;

        @Parameters(paramLabel = "DIR", description = "An existing folder; they go to their places below share in it.")
        private Path folder;

        @Override
        public Integer call() throws IOException {
            CommandLine twister = spec.root().commandLine();
            write("man/man1/twister.1", ManPage.of(twister));
            write("bash-completion/completions/twister", AutoComplete.bash("twister", twister));
            write("zsh/vendor-completions/_twister", ShellCompletion.zsh(twister.getCommandSpec()));
            write("fish/vendor_completions.d/twister.fish", ShellCompletion.fish(twister.getCommandSpec()));
            return ExitCode.OK;
        }

        private void write(String place, String text) throws IOException {
            Path file = folder.resolve("share").resolve(place);
            Files.createDirectories(file.getParent());
            WholeFile.write(file, out -> out.write(text.getBytes(StandardCharsets.UTF_8)));
        }
    }

    /** What {@code --version} prints. */
    static final class VersionProvider implements IVersionProvider {
        @Override
        public String[] getVersion() {
            return new String[] {"twister " + TwisterVersion.text(), "JDK " + Runtime.version()};
        }
    }

    /** Runs a command line in this process. */
    @FunctionalInterface
    public interface CommandRunner {
        /** Runs a command line and returns its exit code. */
        int run(PrintWriter out, PrintWriter err, String... arguments);

        /**
         * Runs a command line whose failure is the caller's.
         *
         * @throws BadInputException for {@link ExitCode#BAD_INPUT}, with the command's message
         * @throws EngineException for every other code but {@link ExitCode#OK}
         */
        default void require(Writer out, List<String> arguments) {
            StringWriter err = new StringWriter();
            int exitCode =
                    run(new PrintWriter(out, true), new PrintWriter(err, true), arguments.toArray(String[]::new));
            if (exitCode != ExitCode.OK) {
                String message = err.toString().strip().replaceFirst("^twister: ", "");
                throw exitCode == ExitCode.BAD_INPUT ? new BadInputException(message) : new EngineException(message);
            }
        }
    }
}
