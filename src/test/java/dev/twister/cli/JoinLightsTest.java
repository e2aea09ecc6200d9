package dev.twister.cli;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import dev.twister.denoise.FakeDenoiser;
import dev.twister.image.ExrPicture;
import dev.twister.image.ExrReader;
import java.io.File;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** {@code render --light-layers}, and {@code join --light} on what it writes. */
class JoinLightsTest {
    @TempDir
    private Path folder;

    @Test
    void strengthAndColorMultiplyTheLayer() throws IOException {
        ExrPicture before = render("--samples", "2", "-o", file("a.exr"));
        ExrPicture relit = join(file("a.exr"), "--light", "emitters=2.5,#ff0000");

        assertThat(value(relit, "R")).isCloseTo(2.5f * value(before, "R"), within(1e-6f));
        assertThat(value(relit, "G")).isZero();
        assertThat(value(relit, "light-emitters.R")).isEqualTo(value(relit, "R"));
        assertThat(value(relit, "guide-albedo.R")).isEqualTo(value(before, "guide-albedo.R"));
    }

    @Test
    void rangesAreJoinedFirst() throws IOException {
        ExrPicture whole = render("--samples", "4", "-o", file("whole.exr"));
        render("--sample-range", "0-1", "-o", file("1.exr"));
        render("--sample-range", "2-3", "-o", file("2.exr"));
        ExrPicture relit = join(file("1.exr"), file("2.exr"), "--light", "emitters=2");

        assertThat(value(relit, "R")).isCloseTo(2 * value(whole, "R"), within(1e-6f));
    }

    @Test
    void theNewPictureIsDenoised() throws IOException {
        System.setProperty(FakeDenoiser.PROPERTY, "true");
        try {
            ExrPicture before = render("--samples", "2", "--denoise", "-o", file("a.exr"));
            ExrPicture relit = join(file("a.exr"), "--light", "emitters=2", "--denoise");

            assertThat(value(relit, "noisy.R")).isCloseTo(2 * value(before, "noisy.R"), within(1e-6f));
            assertThat(value(relit, "R") - value(relit, "noisy.R"))
                    .isCloseTo(value(before, "R") - value(before, "noisy.R"), within(1e-3f));
        } finally {
            System.clearProperty(FakeDenoiser.PROPERTY);
        }
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "lamp=2        | has no light layer 'lamp'; it has: emitters, lights",
                "emitters      | is not a light's change",
                "emitters=     | is not a light's change",
                "emitters=2,   | is not a light's change",
                "emitters=-1   | is not a light's change",
                "emitters=1e9  | is not a light's change",
                "emitters=#12  | is not a light's change",
                "emitters=1000001 | must be from 0 to 1000000"
            })
    void whatCannotBeChangedIsSaid(String change, String message) throws IOException {
        render("--samples", "1", "-o", file("a.exr"));
        Outcome outcome = Outcome.of("join", file("a.exr"), "--light", change, "-o", file("b.exr"));

        assertThat(outcome.exitCode()).isEqualTo(ExitCode.BAD_INPUT);
        assertThat(outcome.err()).contains(message);
    }

    @ParameterizedTest
    @ValueSource(strings = {"sky", "ambient", "emitters"})
    void aGroupOfLightsWithTheNameOfOtherLightIsRefused(String name) throws IOException {
        Path scene = Files.writeString(
                folder.resolve("named.json"),
                Files.readString(Path.of("scenes", "teaching.json"))
                        .replace("\"version\": 1", "\"version\": 3")
                        .replace("\"light\": {", "\"light\": {\"lightGroup\": \"" + name + "\", ")
                        .replace(
                                "../skyboxes",
                                new File("skyboxes").getAbsolutePath().replace('\\', '/')));
        String[] plain = {"render", scene.toString(), "--size", "4x4", "--engine", "sequential", "-o", file("a.exr")};
        String[] layered = Stream.concat(Stream.of(plain), Stream.of("--light-layers"))
                .toArray(String[]::new);

        assertThat(Outcome.of(plain).exitCode()).isZero();
        assertThat(Outcome.of(layered).exitCode()).isEqualTo(ExitCode.BAD_INPUT);
        assertThat(Outcome.of(layered).err())
                .startsWith("twister: lightGroup is '" + name + "'")
                .hasLineCount(1);
    }

    @Test
    void aPictureWithoutLayersIsRefused() {
        Outcome.of("render", "cornell", "--engine", "sequential", "--size", "4x4", "-o", file("plain.exr"));
        Outcome outcome = Outcome.of("join", file("plain.exr"), "--light", "lights=2", "-o", file("b.exr"));

        assertThat(outcome.exitCode()).isEqualTo(ExitCode.BAD_INPUT);
        assertThat(outcome.err()).contains("has no light layers; render it with --light-layers");
    }

    private ExrPicture render(String... arguments) throws IOException {
        List<String> all = new ArrayList<>(
                List.of("render", "cornell", "--engine", "sequential", "--size", "12x12", "--light-layers"));
        all.addAll(List.of(arguments));
        assertThat(Outcome.of(all.toArray(String[]::new)).exitCode()).isZero();
        return ExrReader.read(Path.of(arguments[arguments.length - 1]));
    }

    private ExrPicture join(String... arguments) throws IOException {
        List<String> all = new ArrayList<>(List.of("join", "-o", file("joined.exr")));
        all.addAll(List.of(arguments));
        assertThat(Outcome.of(all.toArray(String[]::new)).exitCode()).isZero();
        return ExrReader.read(folder.resolve("joined.exr"));
    }

    private String file(String name) {
        return folder.resolve(name).toString();
    }

    /** Of the pixel in the middle. */
    private static float value(ExrPicture picture, String channel) {
        return picture.channels().stream()
                .filter(each -> each.name().equals(channel))
                .findFirst()
                .orElseThrow()
                .values()[12 * 6 + 6];
    }
}
