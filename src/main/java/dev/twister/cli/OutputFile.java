package dev.twister.cli;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;

/** Looks at where a result is to go before the work is done, not after it. */
final class OutputFile {
    private OutputFile() {}

    static void check(String option, Path file) {
        Path folder = file.toAbsolutePath().getParent();
        if (folder == null || Files.isDirectory(file)) {
            throw new BadInputException(option + " is " + file + ", but must be a file, not a folder");
        }
        if (!Files.isDirectory(folder)) {
            throw new BadInputException(option + " is " + file + ", but there is no folder " + folder);
        }
        // A regular file is replaced, which is up to its folder; anything else, /dev/null say, is written to.
        boolean replaced = !Files.exists(file) || Files.isRegularFile(file);
        boolean writable = Files.isWritable(replaced ? folder : file);
        if (!writable) {
            throw new BadInputException(option + " is " + file + ", but there is no permission to write there");
        }
    }

    static boolean endsIn(Path file, String ending) {
        return file.toString().toLowerCase(Locale.ROOT).endsWith(ending);
    }
}
