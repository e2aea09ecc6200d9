package dev.twister.cli;

import dev.twister.files.PrintableText;
import java.io.IOException;
import java.io.Writer;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * Everything that commands print goes through this, so that no text of a user's controls the terminal that shows it.
 */
final class PrintableWriter extends Writer {
    /** Lines, tables and the bar of progress are made of them. */
    private static final Pattern BETWEEN = Pattern.compile("[^\n\r\t]+");

    private final Writer out;

    PrintableWriter(Writer out) {
        this.out = out;
    }

    @Override
    public void write(char[] characters, int offset, int length) throws IOException {
        String text = new String(characters, offset, length);
        out.write(BETWEEN.matcher(text).replaceAll(part -> Matcher.quoteReplacement(PrintableText.line(part.group()))));
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
