package dev.twister.scene.format.json;

import dev.twister.files.PrintableText;

/** Text from outside made fit for a message: one line, short, and without characters that a terminal would obey. */
public final class Excerpt {
    private static final int MAX_VALUE_LENGTH = 40;
    private static final int MAX_SENTENCE_LENGTH = 160;
    private static final int MAX_PATH_LENGTH = 300;

    private Excerpt() {}

    /** In quotation marks, at most {@value #MAX_VALUE_LENGTH} characters of it. */
    public static String quoted(String text) {
        return '"' + shortened(text) + '"';
    }

    /** At most {@value #MAX_VALUE_LENGTH} characters of it. */
    public static String shortened(String text) {
        return start(text, MAX_VALUE_LENGTH);
    }

    /** At most {@value #MAX_SENTENCE_LENGTH} characters of it. */
    public static String sentence(String text) {
        return start(text, MAX_SENTENCE_LENGTH);
    }

    /** A file's name, of which the end says most. */
    public static String ofPath(String path) {
        if (path.length() <= MAX_PATH_LENGTH) {
            return PrintableText.line(path);
        }
        return "..." + PrintableText.line(path.substring(path.length() - MAX_PATH_LENGTH));
    }

    private static String start(String text, int length) {
        return text.length() <= length
                ? PrintableText.line(text)
                : PrintableText.line(text.substring(0, length)) + "...";
    }
}
