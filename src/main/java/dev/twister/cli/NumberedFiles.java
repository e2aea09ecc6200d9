package dev.twister.cli;

import java.nio.file.Path;
import java.util.Locale;

/** Names for frames: {@code fall.png} becomes {@code fall-0000.png} and so on, which sort as they were drawn. */
final class NumberedFiles {
    private static final int MIN_DIGITS = 4;

    private final Path file;
    private final int digits;

    /**
     * Names for so many files.
     *
     * @param file has an ending
     */
    NumberedFiles(Path file, int count) {
        this.file = file;
        digits = Math.max(MIN_DIGITS, Integer.toString(count - 1).length());
    }

    /** The file of a number, from 0. */
    Path file(int number) {
        String name = file.getFileName().toString();
        int ending = name.lastIndexOf('.');
        String numbered = String.format(
                Locale.ROOT, "%s-%0" + digits + "d%s", name.substring(0, ending), number, name.substring(ending));
        return file.resolveSibling(numbered);
    }
}
