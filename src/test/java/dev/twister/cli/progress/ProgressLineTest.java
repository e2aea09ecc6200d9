package dev.twister.cli.progress;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.PrintWriter;
import java.io.StringWriter;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class ProgressLineTest {
    private final StringWriter shown = new StringWriter();
    private final PrintWriter err = new PrintWriter(shown, true);

    @ParameterizedTest
    @ValueSource(ints = {2, 10, 40, 80, 300})
    void staysInOneLineOfTheTerminal(int terminal) {
        try (ProgressLine line = ProgressLine.start(err, "vector 1280x720", 10, terminal)) {
            line.stepTo(7);
            line.says("sequential 3840x2160");
        }

        List<String> lines = List.of(shown.toString().split("\r", -1));
        assertThat(lines).hasSizeGreaterThan(2).allSatisfy(text -> {
            assertThat(text).hasSizeLessThan(terminal);
            assertThat(text).doesNotContain("\n");
        });
        assertThat(lines.get(lines.size() - 2)).isBlank();
        assertThat(lines.getLast()).isEmpty();
    }

    @Test
    void tellsTheTaskAndHowFarItIs() {
        try (ProgressLine line = ProgressLine.start(err, "vector", 10, 80)) {
            line.stepTo(7);
        }

        assertThat(shown.toString()).contains("vector", "70%");
    }

    @Test
    void isSilentWhereThereIsNoTerminal() {
        try (ProgressLine line = ProgressLine.start(err, "vector", 10, 0)) {
            line.step();
        }

        assertThat(shown.toString()).isEmpty();
    }
}
