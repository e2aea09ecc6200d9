package dev.twister.cli.command;

import dev.twister.cli.file.BadInputException;
import dev.twister.cli.file.ExitCode;
import dev.twister.engine.EngineException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.io.Writer;
import java.util.List;

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
        int exitCode = run(new PrintWriter(out, true), new PrintWriter(err, true), arguments.toArray(String[]::new));
        if (exitCode != ExitCode.OK) {
            String message = err.toString().strip().replaceFirst("^twister: ", "");
            throw exitCode == ExitCode.BAD_INPUT ? new BadInputException(message) : new EngineException(message);
        }
    }
}
