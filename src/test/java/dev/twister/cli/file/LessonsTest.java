package dev.twister.cli.file;

import static org.assertj.core.api.Assertions.assertThat;

import dev.twister.cli.Outcome;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/**
 * Runs the commands of the lessons: pictures must equal the ones beside the page, and the output must contain the lines
 * of the text block that follows the command; runs of spaces compare equal.
 */
class LessonsTest {
    private static final Path FOLDER = Path.of("docs/lessons");
    private static final Pattern COMMAND =
            Pattern.compile("```bash\\nscripts/twister ([^\\n]+)\\n```(?:\\s+```text\\n(.*?)```)?", Pattern.DOTALL);

    private static final Pattern METHOD = Pattern.compile("\\[`(\\w+)\\.(\\w+)`\\]\\(([^)]+\\.java)\\)");

    @TempDir
    private Path folder;

    static List<Path> lessons() throws IOException {
        try (Stream<Path> files = Files.list(FOLDER)) {
            return files.filter(file -> file.getFileName().toString().matches("\\d.*\\.md"))
                    .sorted()
                    .toList();
        }
    }

    @Tag("slow")
    @ParameterizedTest
    @MethodSource("lessons")
    void lessonIsTrue(Path lesson) throws IOException {
        String text = Files.readString(lesson);
        int answers = 0;
        int pictures = 0;
        for (var command : COMMAND.matcher(text).results().toList()) {
            List<String> words = new ArrayList<>(Arrays.asList(command.group(1).split(" ")));
            if (words.getFirst().equals("render")) {
                pictureIsMade(words, text);
                pictures++;
            } else {
                Outcome outcome = Outcome.of(words.toArray(String[]::new));
                assertThat(outcome.exitCode()).as(outcome.err()).isEqualTo(ExitCode.OK);
                String printed = plain(outcome.out());
                command.group(2).lines().forEach(line -> assertThat(printed).contains(plain(line)));
                answers++;
            }
        }
        assertThat(pictures).isPositive();
        assertThat(answers).isGreaterThanOrEqualTo(2);
        assertThat(text.split("```bash\n", -1)).hasSize(1 + pictures + answers);
        assertThat(text.split("<details>", -1)).hasSize(3);
    }

    @ParameterizedTest
    @MethodSource("lessons")
    void methodsThatALessonNamesAreThere(Path lesson) throws IOException {
        var methods = METHOD.matcher(Files.readString(lesson)).results().toList();
        assertThat(methods).isNotEmpty();
        for (var method : methods) {
            Path source = FOLDER.resolve(method.group(3));
            assertThat(source).hasFileName(method.group(1) + ".java");
            assertThat(Files.readString(source)).containsPattern(" static \\w[\\w\\[\\]]* " + method.group(2) + "\\(");
        }
    }

    private void pictureIsMade(List<String> words, String text) throws IOException {
        int place = words.indexOf("-o") + 1;
        String name = words.get(place);
        assertThat(text).contains("](" + name + ")");
        words.set(place, folder.resolve(name).toString());
        words.addAll(List.of("--engine", "parallel"));
        Outcome outcome = Outcome.of(words.toArray(String[]::new));
        assertThat(outcome.exitCode()).as(outcome.err()).isEqualTo(ExitCode.OK);
        assertThat(pixels(folder.resolve(name))).isEqualTo(pixels(FOLDER.resolve(name)));
    }

    private static int[] pixels(Path file) throws IOException {
        BufferedImage image = ImageIO.read(file.toFile());
        return image.getRGB(0, 0, image.getWidth(), image.getHeight(), null, 0, image.getWidth());
    }

    private static String plain(String text) {
        return text.strip().replaceAll("\\s+", " ");
    }
}
