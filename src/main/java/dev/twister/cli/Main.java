package dev.twister.cli;

import dev.twister.bench.benchmark.EngineFailure;
import dev.twister.cli.command.Failures;
import dev.twister.cli.command.TwisterCommand;
import dev.twister.cli.file.CommonOptions;
import dev.twister.cli.file.ExitCode;
import dev.twister.cli.file.PathConverter;
import dev.twister.cli.option.ChoiceConverter;
import dev.twister.files.PrintableText;
import dev.twister.files.TwisterVersion;
import java.io.FileDescriptor;
import java.io.FileOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.io.PrintWriter;
import java.io.Writer;
import java.lang.management.ManagementFactory;
import java.lang.management.MemoryType;
import java.lang.reflect.Constructor;
import java.lang.reflect.InaccessibleObjectException;
import java.nio.charset.Charset;
import java.nio.file.Path;
import java.time.Duration;
import java.util.Locale;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import picocli.CommandLine;
import picocli.CommandLine.ParseResult;
import picocli.CommandLine.RunLast;

/** Where Twister starts. */
public final class Main {
    private static final int HELP_WIDTH = 100;

    private Main() {}

    public static void main(String[] arguments) {
        takeStandardError();
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

    /** The launcher lets a filter read what the JVM prints, and names the descriptor of the true standard error. */
    private static void takeStandardError() {
        Integer descriptor = Integer.getInteger("twister.stderr");
        if (descriptor == null) {
            return;
        }
        try {
            Constructor<FileDescriptor> constructor = FileDescriptor.class.getDeclaredConstructor(int.class);
            constructor.setAccessible(true);
            FileOutputStream out = new FileOutputStream(constructor.newInstance(descriptor));
            System.setErr(new PrintStream(out, true, System.err.charset()));
        } catch (ReflectiveOperationException | InaccessibleObjectException _) {
            // The filter passes on what Twister prints, too.
        }
    }

    /** Runs one command line and returns the exit code; never throws, and never ends the process. */
    public static int run(PrintWriter out, PrintWriter err, String... arguments) {
        CommandLine commandLine = commandLine(out, err);
        try {
            return commandLine.execute(arguments);
        } catch (OutOfMemoryError _) {
            err.println("twister: " + EngineFailure.outOfMemory());
            return ExitCode.BAD_INPUT;
        }
    }

    /** All commands. */
    static CommandLine commandLine(PrintWriter out, PrintWriter err) {
        CommandLine commandLine = new CommandLine(new TwisterCommand(Main::run))
                .setOut(out)
                .setErr(printable(err))
                .setExpandAtFiles(false)
                .registerConverter(Path.class, new PathConverter())
                .setUsageHelpWidth(HELP_WIDTH)
                .setExecutionStrategy(parsed -> execute(parsed, out))
                .setParameterExceptionHandler(Failures::explainParameter)
                .setExecutionExceptionHandler(Failures::explain);
        commandLine.getSubcommands().values().forEach(command -> ChoiceConverter.applyTo(command.getCommandSpec()));
        return commandLine;
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

    /**
     * Everything that commands print goes through this, so that no text of a user's controls the terminal that shows
     * it.
     */
    static final class PrintableWriter extends Writer {
        /** Lines, tables and the bar of progress are made of them. */
        private static final Pattern BETWEEN = Pattern.compile("[^\n\r\t]+");

        private final Writer out;

        PrintableWriter(Writer out) {
            this.out = out;
        }

        @Override
        public void write(char[] characters, int offset, int length) throws IOException {
            String text = new String(characters, offset, length);
            out.write(BETWEEN.matcher(text)
                    .replaceAll(part -> Matcher.quoteReplacement(PrintableText.line(part.group()))));
        }

        @Override
        public void flush() throws IOException {
            out.flush();
        }

        @Override
        public void close() throws IOException {
            out.close();
        }
    }

    /** What {@code --verbose} prints after a command that begins now: version, time and memory. */
    private static final class RunFigures {
        private static final double MILLIS_PER_SECOND = 1000;
        private static final double BYTES_PER_MEBIBYTE = 1 << 20;

        private final long start = System.nanoTime();

        void print(PrintWriter err) {
            ProcessHandle.Info process = ProcessHandle.current().info();
            double processorSeconds =
                    process.totalCpuDuration().orElse(Duration.ZERO).toMillis() / MILLIS_PER_SECOND;
            err.printf(
                    Locale.ROOT,
                    "twister %s on Java %s (%s): %.1f s, %.1f s of processor time with the start, heap up to %.0f MiB%n",
                    TwisterVersion.text(),
                    Runtime.version(),
                    System.getProperty("java.vm.name"),
                    Duration.ofNanos(System.nanoTime() - start).toMillis() / MILLIS_PER_SECOND,
                    processorSeconds,
                    heapBytes() / BYTES_PER_MEBIBYTE);
        }

        /** The sum of the most that each part of the heap held. */
        private static long heapBytes() {
            return ManagementFactory.getMemoryPoolMXBeans().stream()
                    .filter(pool -> pool.getType() == MemoryType.HEAP)
                    .map(pool -> pool.getPeakUsage())
                    .mapToLong(usage -> usage.getUsed())
                    .sum();
        }
    }
}
