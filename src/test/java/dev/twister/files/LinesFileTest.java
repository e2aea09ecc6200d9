package dev.twister.files;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIOException;

import dev.twister.ChildJvm;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class LinesFileTest {
    private static final int LINES = 25;

    /** Longer than a page, so that a line is not one write of the system by chance. */
    private static final int LINE_LENGTH = 20_000;

    @TempDir
    private Path folder;

    @Test
    void linesOfSeveralProcessesAreAllThereAndWhole() throws IOException, InterruptedException {
        Path file = folder.resolve("reports.jsonl");
        List<Process> processes = new ArrayList<>();
        for (int number = 0; number < 4; number++) {
            processes.add(ChildJvm.start(ChildJvm.of(AppendingMain.class, file.toString(), Integer.toString(number))
                    .inheritIO()));
        }
        for (Process process : processes) {
            assertThat(process.waitFor()).isZero();
        }

        assertThat(Files.readAllLines(file))
                .containsExactlyInAnyOrderElementsOf(IntStream.range(0, 4)
                        .boxed()
                        .flatMap(LinesFileTest::lines)
                        .toList());
    }

    @Test
    void linesOfSeveralThreadsAreAllThere() throws IOException {
        Path file = folder.resolve("reports.jsonl");
        IntStream.range(0, 100).parallel().forEach(number -> appendUnchecked(file, Integer.toString(number)));

        assertThat(Files.readAllLines(file)).hasSize(100).doesNotHaveDuplicates();
    }

    @Test
    void aMissingLastLineFeedIsAdded() throws IOException {
        Path file = Files.writeString(folder.resolve("reports.jsonl"), "one\ntwo");

        append(file, "three");

        assertThat(file).hasContent("one\ntwo\nthree\n");
    }

    @Test
    void tellsWhichFileCannotBeWritten() {
        Path file = folder.resolve("missing/reports.jsonl");

        assertThatIOException()
                .isThrownBy(() -> append(file, "x"))
                .withMessage("cannot write " + file + ": there is no folder " + file.getParent());
    }

    private static Stream<String> lines(int process) {
        return IntStream.range(0, LINES).mapToObj(line -> process + " " + line + " " + "x".repeat(LINE_LENGTH));
    }

    private static void append(Path file, String line) throws IOException {
        LinesFile.append(file, line.getBytes(StandardCharsets.UTF_8));
    }

    private static void appendUnchecked(Path file, String line) {
        try {
            append(file, line);
        } catch (IOException failure) {
            throw new UncheckedIOException(failure);
        }
    }

    /** Appends the lines of a process. */
    static final class AppendingMain {
        private AppendingMain() {}

        public static void main(String[] arguments) throws IOException {
            for (String line : lines(Integer.parseInt(arguments[1])).toList()) {
                append(Path.of(arguments[0]), line);
            }
        }
    }
}
