package dev.twister.cli.file;

import dev.twister.files.PrintableText;
import dev.twister.files.SystemReason;
import dev.twister.files.WholeFile;
import dev.twister.render.SceneInputs;
import java.io.Console;
import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import picocli.CommandLine;

/** Checks output files before the work begins. */
public final class OutputFile {
    private OutputFile() {}

    public static boolean isStandardOutput(Path output) {
        return output.equals(WholeFile.STANDARD_OUTPUT);
    }

    /**
     * Checks a file of text, or standard output.
     *
     * @throws BadInputException if it cannot be written
     */
    public static void checkText(String option, Path file) {
        if (!isStandardOutput(file)) {
            check(option, file);
        }
    }

    /**
     * Checks a file of binary data, or standard output.
     *
     * @throws BadInputException if it cannot be written, or standard output is a terminal
     */
    public static void checkBinary(String option, Path file) {
        if (!isStandardOutput(file)) {
            check(option, file);
        } else if (Optional.ofNullable(System.console())
                .map(Console::isTerminal)
                .orElse(false)) {
            throw new BadInputException(
                    option + " is -, but standard output is a terminal; redirect it to a file or a program");
        }
    }

    /** The file's name for people. */
    public static String name(Path file) {
        return isStandardOutput(file) ? "standard output" : PrintableText.line(file.toString());
    }

    /** Where a command says what it wrote: nowhere with {@code --quiet}, and not among what it writes. */
    public static PrintWriter notes(CommandLine command, Path file) {
        boolean isQuiet = CommonOptions.isGiven(CommonOptions.QUIET, command);
        return isQuiet || isStandardOutput(file) ? command.getErr() : command.getOut();
    }

    public static void check(String option, Path file) {
        if (isStandardOutput(file)) {
            throw new BadInputException(option
                    + " is -, but this is not written to standard output; give a file, ./- for one of that name");
        }
        Path folder = folderOf(option, file);
        if (folder == null || Files.isDirectory(file)) {
            throw new BadInputException(option + " is " + file + ", but must be a file, not a folder");
        }
        if (!Files.isDirectory(folder)) {
            throw new BadInputException(option + " is " + file + ", but there is no folder " + folder);
        }
        // Replacing a regular file needs permission for its folder; a device is written directly.
        boolean replaced = !Files.exists(file) || Files.isRegularFile(file);
        boolean writable = Files.isWritable(replaced ? folder : file);
        if (!writable) {
            throw new BadInputException(option + " is " + file + ", but there is no permission to write there");
        }
        if (replaced) {
            WholeFile.deleteLeftovers(folder);
            checkByTrial(option, file);
        }
    }

    /** What only the system knows before anything is written: the longest name, say, or a folder that takes no file. */
    private static void checkByTrial(String option, Path file) {
        try {
            WholeFile.tryToReplace(file);
        } catch (IOException problem) {
            throw new BadInputException(option + " is " + file + ", but " + SystemReason.of(problem));
        }
    }

    /** The one that is written in: behind links, where the file is one. */
    private static Path folderOf(String option, Path file) {
        try {
            return WholeFile.behindLinks(file).getParent();
        } catch (IOException problem) {
            throw new BadInputException(option + " is " + file + ", but " + SystemReason.of(problem));
        }
    }

    /**
     * Whether what is written to one file is lost when the other one is written; devices and pipes take both. Names
     * that differ in case alone are one file on some systems, and nobody wants two such on the others.
     */
    static boolean replaces(Path one, Path other) throws IOException {
        if (Files.exists(one) && Files.exists(other)) {
            return Files.isRegularFile(one) && Files.isSameFile(one, other);
        }
        Path place = WholeFile.behindLinks(one);
        Path otherPlace = WholeFile.behindLinks(other);
        return place.getFileName()
                        .toString()
                        .equalsIgnoreCase(otherPlace.getFileName().toString())
                && Files.isSameFile(place.resolveSibling(""), otherPlace.resolveSibling(""));
    }

    /**
     * Keeps what a result is made from.
     *
     * @param inputs files that are there
     * @throws BadInputException where the result would replace one of them
     */
    public static void checkKeeps(String option, Path file, List<Path> inputs) throws IOException {
        if (!isStandardOutput(file) && SceneInputs.areReplacedBy(file, inputs)) {
            throw new BadInputException(
                    option + " would replace " + file + ", which is read for it; give another file");
        }
    }

    public static boolean endsIn(Path file, String ending) {
        return file.toString().toLowerCase(Locale.ROOT).endsWith(ending);
    }
}
