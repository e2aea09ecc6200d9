package dev.twister.cli.command;

import static org.assertj.core.api.Assertions.assertThat;

import dev.twister.cli.Outcome;
import dev.twister.cli.file.ExitCode;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Base64;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The page with the paper's figures and the commands that it lists. */
class FiguresCommandTest {
    private static final Pattern PICTURE =
            Pattern.compile("src=\"data:image/png;base64,([^\"]+)\">.*?<pre class=\"command\">([^<]+)</pre>");
    private static final Pattern TITLE = Pattern.compile("<h2>([^<]+)</h2>");

    @TempDir
    private Path folder;

    @Test
    void pageHasEveryFigureAndCommandsThatMakeThem() throws IOException {
        Path page = folder.resolve("figures.html");
        Outcome outcome = Outcome.of("figures", "-o", page.toString());

        assertThat(outcome.exitCode()).as(outcome.err()).isEqualTo(ExitCode.OK);
        String html = Files.readString(page);
        assertThat(TITLE.matcher(html).results().map(found -> found.group(1)))
                .containsExactly(
                        "The closest hit",
                        "Levels of reflectivity",
                        "Blinn-Phong and its parts",
                        "Hard shadows",
                        "Samples on the light's disc",
                        "Soft shadows",
                        "Reflections, bounce by bounce",
                        "Reflections",
                        "The skybox");
        assertThat(html).doesNotContain("src=\"http").doesNotContain("href=");
        assertThat(html.split("image/svg", -1)).hasSize(5);
        List<Matcher> pictures = pictures(html);
        assertThat(pictures).hasSize(16);
        assertThat(pictures.stream().map(picture -> picture.group(1))).doesNotHaveDuplicates();
        for (Matcher picture : List.of(pictures.getFirst(), pictures.get(1), pictures.getLast())) {
            assertThat(made(picture.group(2))).isEqualTo(Base64.getDecoder().decode(picture.group(1)));
        }
    }

    @Test
    void placesThatCannotBeWrittenAreRefused() {
        Outcome outcome =
                Outcome.of("figures", "-o", folder.resolve("none/figures.html").toString());

        assertThat(outcome.exitCode()).isEqualTo(ExitCode.BAD_INPUT);
        assertThat(outcome.err().lines()).singleElement().asString().startsWith("twister: --output is ");
    }

    private static List<Matcher> pictures(String html) {
        List<Matcher> pictures = new ArrayList<>();
        html.lines().forEach(line -> {
            Matcher picture = PICTURE.matcher(line);
            if (picture.find()) {
                pictures.add(picture);
            }
        });
        return pictures;
    }

    /** Runs a command of the page, with its output in a temporary folder, and returns the bytes that it writes. */
    private byte[] made(String command) throws IOException {
        List<String> words = new ArrayList<>(List.of(command.split(" ")));
        assertThat(words.removeFirst()).isEqualTo("scripts/twister");
        Path file = folder.resolve(words.get(3));
        words.set(3, file.toString());
        words.addAll(List.of("--engine", "parallel"));
        Outcome outcome = Outcome.of(words.toArray(String[]::new));
        assertThat(outcome.exitCode()).as(outcome.err()).isEqualTo(ExitCode.OK);
        return Files.readAllBytes(file);
    }
}
