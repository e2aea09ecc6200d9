package dev.twister.mesh.input;

import dev.twister.files.PrintableText;
import java.nio.file.Path;

/** Text from files, prepared for messages: short and on one line. */
public final class QuotedText {
    private static final int TEXT_LENGTH = 60;

    private QuotedText() {}

    public static String path(Path file) {
        return PrintableText.line(file.toString());
    }

    /** Quoted; long texts are truncated. */
    public static String text(String text) {
        return text.length() <= TEXT_LENGTH
                ? "'" + PrintableText.line(text) + "'"
                : "'" + PrintableText.line(text.substring(0, TEXT_LENGTH)) + "...'";
    }
}
