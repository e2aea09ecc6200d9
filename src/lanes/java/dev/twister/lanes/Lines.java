package dev.twister.lanes;

import java.util.Locale;

/** Java text with indentation. */
final class Lines {
    private final StringBuilder text = new StringBuilder();
    private int depth;

    void add(String line) {
        text.append("    ".repeat(depth)).append(line).append('\n');
    }

    /** Adds a line of a format. */
    @SuppressWarnings("AnnotateFormatMethod") // the compiler runs without libraries
    void add(String format, Object... arguments) {
        add(String.format(Locale.ROOT, format, arguments));
    }

    /** Adds a line that ends in a brace, the body and the closing brace. */
    void block(String head, Runnable body) {
        add(head + " {");
        depth++;
        body.run();
        depth--;
        add("}");
    }

    @Override
    public String toString() {
        return text.toString();
    }
}
