package dev.twister.cli.command;

import dev.twister.cli.file.BadInputException;
import dev.twister.cli.file.CommonOptions;
import dev.twister.cli.file.ExitCode;
import dev.twister.denoise.DenoiseException;
import dev.twister.engine.EngineException;
import dev.twister.engine.UnknownEngineException;
import dev.twister.files.PrintableText;
import dev.twister.gui.Gui.NoDisplayException;
import dev.twister.mesh.MeshException;
import dev.twister.scene.SceneException;
import dev.twister.sky.SkyException;
import java.io.IOException;
import java.io.PrintWriter;
import java.io.UncheckedIOException;
import java.util.List;
import java.util.Locale;
import java.util.stream.Collectors;
import picocli.CommandLine;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.ParseResult;
import picocli.CommandLine.UnmatchedArgumentException;

/** Says what went wrong in a line, and with which exit code that ends. */
public final class Failures {
    private Failures() {}

    /** A command line that picocli could not read. */
    public static int explainParameter(ParameterException failure, String[] arguments) {
        CommandLine command = failure.getCommandLine();
        PrintWriter err = command.getErr();
        err.println("twister: " + PrintableText.line(message(failure)));
        UnmatchedArgumentException.printSuggestions(failure, err);
        err.println("Try '" + command.getCommandSpec().qualifiedName() + " --help'.");
        return ExitCode.BAD_INPUT;
    }

    private static String message(ParameterException failure) {
        return switch (failure) {
            case UnmatchedArgumentException unmatched -> unknown(unmatched);
            // What a converter found out of range.
            case ParameterException _ when failure.getCause() instanceof BadInputException bad -> bad.getMessage();
            default -> inSmallLetter(failure.getMessage().replaceFirst("^Error: ", ""));
        };
    }

    private static String unknown(UnmatchedArgumentException failure) {
        List<String> unmatched = failure.getUnmatched();
        boolean isCommand = failure.getCommandLine().getParent() == null;
        String kind = isCommand ? "command" : failure.isUnknownOption() ? "option" : "argument";
        return "unknown " + kind + (unmatched.size() == 1 ? " " : "s ")
                + unmatched.stream().map(text -> "'" + text + "'").collect(Collectors.joining(", "));
    }

    private static String inSmallLetter(String sentence) {
        return sentence.substring(0, 1).toLowerCase(Locale.ROOT) + sentence.substring(1);
    }

    /** What a command threw; whatever is not foreseen is a bug of Twister's and shows where it happened. */
    public static int explain(Exception failure, CommandLine command, ParseResult parsed) {
        PrintWriter err = root(command).getErr();
        boolean verbose = CommonOptions.isGiven(CommonOptions.VERBOSE, command);
        if (verbose) {
            failure.printStackTrace(err);
        }
        return switch (failure) {
            case BadInputException _,
                    SceneException _,
                    MeshException _,
                    SkyException _,
                    UnknownEngineException _,
                    NoDisplayException _,
                    DenoiseException _,
                    IOException _ -> say(err, failure);
            case UncheckedIOException wrapped -> say(err, wrapped.getCause());
            case EngineException _ -> {
                // Drivers speak in several lines.
                err.println("twister: " + failure.getMessage());
                yield ExitCode.FAILED;
            }
            default -> {
                err.println("twister: this is a bug of Twister's:");
                if (!verbose) {
                    failure.printStackTrace(err);
                }
                yield ExitCode.FAILED;
            }
        };
    }

    /** Its errors are printed with {@code --quiet} too. */
    private static CommandLine root(CommandLine command) {
        return command.getParent() == null ? command : root(command.getParent());
    }

    private static int say(PrintWriter err, Exception failure) {
        // A scene has a line for each of its faults.
        List<String> lines = failure instanceof SceneException
                ? failure.getMessage().lines().toList()
                : List.of(failure.getMessage());
        lines.forEach(line -> err.println("twister: " + PrintableText.line(line)));
        return ExitCode.BAD_INPUT;
    }
}
