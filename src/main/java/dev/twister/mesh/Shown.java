package dev.twister.mesh;

import dev.twister.files.PrintableText;
import java.nio.file.Path;

/** What files hold, made fit for a message: one line, and short. */
final class Shown {
    private static final int TEXT_LENGTH = 60;

    private Shown() {}

    static String path(Path file) {
        return PrintableText.line(file.toString());
    }

    /** In quotation marks, the start alone of a long text. */
    static String text(String text) {
        return text.length() <= TEXT_LENGTH
                ? "'" + PrintableText.line(text) + "'"
                : "'" + PrintableText.line(text.substring(0, TEXT_LENGTH)) + "...'";
    }
}
