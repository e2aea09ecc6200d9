package dev.twister.cli.progress;

import java.io.PrintWriter;
import java.util.Optional;
import picocli.CommandLine;
import picocli.CommandLine.Option;

/** How long work shows how far it is. */
public final class ProgressOptions {
    /** What {@code --progress} takes. */
    enum Form {
        BAR,
        LINES
    }

    @Option(
            names = "--progress",
            paramLabel = "FORM",
            description =
                    "bar: a bar on a terminal (default); lines: openjd_progress and openjd_status lines on standard"
                            + " output, for schedulers.")
    private Optional<Form> form = Optional.empty();

    boolean areLines() {
        return form.filter(Form.LINES::equals).isPresent();
    }

    /**
     * Begins to show it.
     *
     * @param steps 1 or more
     */
    public ProgressLine start(CommandLine command, String task, long steps) {
        PrintWriter out = command.getOut();
        return areLines()
                ? ProgressLine.of(new StatusLines(out, task, steps, System::nanoTime))
                : ProgressLine.start(command.getErr(), task, steps);
    }
}
