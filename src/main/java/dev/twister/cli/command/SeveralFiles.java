package dev.twister.cli.command;

import dev.twister.cli.file.BadInputException;
import dev.twister.cli.file.ModelFile;
import dev.twister.files.SystemReason;
import java.io.IOException;
import java.nio.file.DirectoryStream;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.regex.Pattern;
import java.util.regex.PatternSyntaxException;

/** The files that one argument means: those of a folder, or of a pattern. */
final class SeveralFiles {
    private static final Pattern WILD = Pattern.compile("[*?\\[{]");

    private SeveralFiles() {}

    /**
     * The mesh files of a folder, or the files whose names match a pattern such as {@code models/*.glb}, in the
     * alphabet's order; empty if the argument is neither.
     *
     * @throws BadInputException if there is no such file
     */
    static Optional<List<Path>> of(String argument) {
        if (argument.isEmpty()) {
            return Optional.empty();
        }
        Path path;
        try {
            path = Path.of(argument);
        } catch (InvalidPathException _) {
            // On Windows a pattern is not a path.
            return Optional.empty();
        }
        if (Files.isDirectory(path)) {
            List<Path> meshes =
                    list(path, "*").stream().filter(ModelFile::isNamed).toList();
            return Optional.of(checked(meshes, "there is no mesh file in the folder " + path));
        }
        String name = String.valueOf(path.getFileName());
        if (Files.exists(path) || !WILD.matcher(name).find()) {
            return Optional.empty();
        }
        Path folder = Optional.ofNullable(path.getParent()).orElse(Path.of(""));
        if (argument.contains("**") || !Files.isDirectory(folder)) {
            throw new BadInputException(
                    "'" + argument + "' is not a pattern of files of one folder; only the file's name"
                            + " may have wildcards, such as models/*.glb");
        }
        return Optional.of(checked(list(folder, name), "no file matches " + argument));
    }

    /** Names of pictures, one for each file: without the ending where that is enough to tell them apart. */
    static List<String> pictures(List<Path> files) {
        List<String> stems = files.stream().map(SeveralFiles::stem).toList();
        List<String> names = new ArrayList<>();
        for (int index = 0; index < stems.size(); index++) {
            String stem = stems.get(index);
            boolean alone = stems.stream().filter(stem::equalsIgnoreCase).count() == 1;
            names.add((alone ? stem : files.get(index).getFileName().toString()) + ".png");
        }
        return names;
    }

    private static String stem(Path file) {
        String name = file.getFileName().toString();
        int dot = name.lastIndexOf('.');
        return dot > 0 ? name.substring(0, dot) : name;
    }

    private static List<Path> list(Path folder, String pattern) {
        List<Path> files = new ArrayList<>();
        try (DirectoryStream<Path> found = Files.newDirectoryStream(folder, pattern)) {
            found.forEach(files::add);
        } catch (IOException problem) {
            throw new BadInputException("the folder " + folder + " cannot be read: " + SystemReason.of(problem));
        } catch (PatternSyntaxException problem) {
            throw new BadInputException("'" + pattern + "' is not a pattern: "
                    + problem.getDescription().toLowerCase(Locale.ROOT));
        }
        // As shells do: hidden files, such as those that macOS leaves beside others, match only by their dot.
        return files.stream()
                .filter(Files::isRegularFile)
                .filter(file -> pattern.startsWith(".")
                        || !file.getFileName().toString().startsWith("."))
                .sorted()
                .toList();
    }

    private static List<Path> checked(List<Path> files, String problem) {
        if (files.isEmpty()) {
            throw new BadInputException(problem);
        }
        return files;
    }
}
