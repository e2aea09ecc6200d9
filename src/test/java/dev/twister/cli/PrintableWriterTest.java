package dev.twister.cli;

import static org.assertj.core.api.Assertions.assertThat;

import dev.twister.cli.Main.PrintableWriter;
import java.io.PrintWriter;
import java.io.StringWriter;
import org.junit.jupiter.api.Test;

class PrintableWriterTest {
    private final StringWriter terminal = new StringWriter();
    private final PrintWriter out = new PrintWriter(new PrintableWriter(terminal));

    @Test
    void whatControlsATerminalIsShown() {
        out.print("\u001b]0;title\u0007 \u009b2J \u202e\u2066 \ud800");

        assertThat(terminal).hasToString("\\u001b]0;title\\u0007 \\u009b2J \\u202e\\u2066 \\ud800");
    }

    @Test
    void linesTablesAndWordsOfAllLanguagesStay() {
        String text = "\rhöhe\t漢字\n\ud83c\udf2a $1 \\ ab\r\n";

        out.print(text);

        assertThat(terminal).hasToString(text);
    }
}
