package dev.twister.cli;

import dev.twister.bench.benchmark.EngineFailure;
import dev.twister.bench.benchmark.Jit;
import dev.twister.cli.command.Failures;
import dev.twister.cli.command.TwisterCommand;
import dev.twister.cli.file.CommonOptions;
import dev.twister.cli.file.ExitCode;
import dev.twister.cli.file.PathConverter;
import dev.twister.cli.option.ChoiceConverter;
import dev.twister.mesh.MeshPose;
import dev.twister.render.Background;
import dev.twister.scene.Integrator;
import dev.twister.scene.ToneMap;
import dev.twister.sky.ShippedSky;
import java.io.PrintWriter;
import java.io.Writer;
import java.nio.charset.Charset;
import java.nio.file.Path;
import picocli.CommandLine;
import picocli.CommandLine.ParseResult;
import picocli.CommandLine.RunLast;

/** Where Twister starts. */
public final class Main {
    private static final int HELP_WIDTH = 100;

    private Main() {}

    public static void main(String[] arguments) {
        Charset outCharset = Charset.forName(System.getProperty("stdout.encoding", "UTF-8"));
        Charset errCharset = Charset.forName(System.getProperty("stderr.encoding", "UTF-8"));
        PrintWriter out = new PrintWriter(System.out, true, outCharset);
        PrintWriter err = new PrintWriter(System.err, true, errCharset);
        int exitCode = run(out, err, arguments);
        // A writer keeps to itself that a disk is full or a pipe closed.
        if (out.checkError() && exitCode == ExitCode.OK) {
            err.println("twister: not all of the output could be written: its disk is full, or its reader is gone");
            exitCode = ExitCode.BAD_INPUT;
        }
        err.flush();
        System.exit(exitCode);
    }

    /** Runs one command line and returns the exit code; never throws, and never ends the process. */
    public static int run(PrintWriter out, PrintWriter err, String... arguments) {
        CommandLine commandLine = new CommandLine(new TwisterCommand(Main::run))
                .setOut(out)
                .setErr(printable(err))
                .setExpandAtFiles(false)
                .registerConverter(Path.class, new PathConverter())
                .registerConverter(Jit.class, new ChoiceConverter<>(Jit.class))
                .registerConverter(Integrator.class, new ChoiceConverter<>(Integrator.class))
                .registerConverter(ToneMap.class, new ChoiceConverter<>(ToneMap.class))
                .registerConverter(Background.class, new ChoiceConverter<>(Background.class))
                .registerConverter(MeshPose.Up.class, new ChoiceConverter<>(MeshPose.Up.class))
                .registerConverter(ShippedSky.class, new ChoiceConverter<>(ShippedSky.class))
                .setUsageHelpWidth(HELP_WIDTH)
                .setExecutionStrategy(parsed -> execute(parsed, out))
                .setParameterExceptionHandler(Failures::explainParameter)
                .setExecutionExceptionHandler(Failures::explain);
        try {
            return commandLine.execute(arguments);
        } catch (OutOfMemoryError _) {
            err.println("twister: " + EngineFailure.outOfMemory());
            return ExitCode.BAD_INPUT;
        }
    }

    // Help holds nothing of the user's, but the colors of terminals.
    private static int execute(ParseResult parsed, PrintWriter out) {
        Integer helped = CommandLine.executeHelpRequest(parsed);
        if (helped != null) {
            return helped;
        }
        CommandLine command = parsed.commandSpec().commandLine();
        command.setOut(printable(out));
        CommandLine last = parsed.asCommandLineList().getLast();
        if (CommonOptions.isGiven(CommonOptions.QUIET, last)) {
            // Failures are told by the command line above it.
            command.getSubcommands().values().forEach(sub -> sub.setErr(new PrintWriter(Writer.nullWriter())));
        }
        RunFigures figures = new RunFigures();
        int exitCode = new RunLast().execute(parsed);
        if (CommonOptions.isGiven(CommonOptions.VERBOSE, last)) {
            figures.print(command.getErr());
        }
        return exitCode;
    }

    private static PrintWriter printable(PrintWriter writer) {
        return new PrintWriter(new PrintableWriter(writer), true);
    }
}
