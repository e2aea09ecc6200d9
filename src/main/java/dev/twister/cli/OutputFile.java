package dev.twister.cli;

import dev.twister.files.SystemReason;
import dev.twister.files.WholeFile;
import dev.twister.render.RenderOutput;
import dev.twister.render.SceneInputs;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;

/** Checks output files before the work begins. */
final class OutputFile {
    private OutputFile() {}

    static boolean isStandardOutput(Path output) {
        return output.equals(RenderOutput.STANDARD_OUTPUT);
    }

    static void check(String option, Path file) {
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
    static void checkKeeps(String option, Path file, List<Path> inputs) throws IOException {
        if (SceneInputs.areReplacedBy(file, inputs)) {
            throw new BadInputException(
                    option + " would replace " + file + ", which is read for it; give another file");
        }
    }

    static boolean endsIn(Path file, String ending) {
        return file.toString().toLowerCase(Locale.ROOT).endsWith(ending);
    }
}
