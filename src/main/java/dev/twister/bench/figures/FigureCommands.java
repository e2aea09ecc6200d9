package dev.twister.bench.figures;

import java.io.Writer;
import java.util.List;

/** Runs the commands of the paper's figures, such as {@code twister render}, in this process. */
@FunctionalInterface
public interface FigureCommands {
    /**
     * Runs a command; if it fails, throws an exception with its error message.
     *
     * @param out receives its standard output
     */
    void run(Writer out, List<String> arguments);
}
