package dev.twister.cli.command;

import static org.assertj.core.api.Assertions.assertThat;

import dev.twister.cli.Outcome;
import dev.twister.cli.file.ExitCode;
import dev.twister.denoise.FakeDenoiser;
import dev.twister.image.ExrPicture;
import dev.twister.image.ExrPicture.ExrChannel;
import dev.twister.image.ExrReader;
import dev.twister.image.ExrWriter;
import dev.twister.image.Provenance;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.ExtendWith;
import org.junit.jupiter.api.io.TempDir;

@ExtendWith(FakeDenoiser.Offered.class)
class DenoiseCommandTest {
    @TempDir
    private Path folder;

    @Test
    void keepsTheNoisyPictureAsALayer() throws IOException {
        Path out = folder.resolve("clean.exr");
        Outcome outcome = denoise(file(0, 2, "R", "G", "B"), out);

        assertThat(outcome.exitCode()).isZero();
        assertThat(value(out, "R")).isEqualTo(2);
        assertThat(value(out, "noisy.R")).isEqualTo(2);
        assertThat(outcome.err()).contains("has no guides").contains("render with --guides");
    }

    @Test
    void usesTheGuides() throws IOException {
        Path out = folder.resolve("clean.exr");
        Path in = file(
                0,
                1,
                "R",
                "G",
                "B",
                "guide-albedo.R",
                "guide-albedo.G",
                "guide-albedo.B",
                "guide-normal.X",
                "guide-normal.Y",
                "guide-normal.Z");
        Outcome outcome = denoise(in, out);

        assertThat(outcome.err()).isEmpty();
        assertThat(value(out, "G")).isEqualTo(111);
        assertThat(value(out, "guide-normal.Z")).isEqualTo(1);
    }

    @Test
    void usesViewsAsGuides() throws IOException {
        Path out = folder.resolve("clean.exr");
        Path in = file(0, 1, "R", "G", "B", "albedo.R", "albedo.G", "albedo.B", "normal.R", "normal.G", "normal.B");
        denoise(in, out);

        assertThat(value(out, "G")).isEqualTo(111);
    }

    @Test
    void denoisesTheNoisyLayerAgain() throws IOException {
        Path once = folder.resolve("once.exr");
        Path twice = folder.resolve("twice.exr");
        denoise(file(0, 2, "R", "G", "B"), once);
        denoise(once, twice);

        assertThat(value(twice, "noisy.R")).isEqualTo(2);
    }

    @Test
    void tellsOfValuesThatAreNotFinite() throws IOException {
        Outcome outcome = denoise(file(0, Float.NaN, "R", "G", "B"), folder.resolve("clean.exr"));

        assertThat(outcome.err()).contains("has 18 values that are not finite; they count as 0");
    }

    @Test
    void refusesAPart() throws IOException {
        Path part = file(1, 2, "R", "G", "B");
        Outcome outcome = denoise(part, folder.resolve("clean.exr"));

        assertThat(outcome.exitCode()).isEqualTo(ExitCode.BAD_INPUT);
        assertThat(outcome.err())
                .isEqualToIgnoringNewLines(
                        "twister: " + part + " has rows 1 to 2 of 3; 'twister join' makes a picture of such parts");
    }

    @Test
    void refusesNumbers() throws IOException {
        Path numbers = file(0, 2, "Y");
        Outcome outcome = denoise(numbers, folder.resolve("clean.exr"));

        assertThat(outcome.exitCode()).isEqualTo(ExitCode.BAD_INPUT);
        assertThat(outcome.err()).isEqualToIgnoringNewLines("twister: " + numbers + " has no colors, only numbers");
    }

    private static Outcome denoise(Path in, Path out) {
        return Outcome.of("denoise", in.toString(), "-o", out.toString());
    }

    private Path file(int firstRow, float value, String... names) throws IOException {
        int rows = 3 - firstRow;
        List<ExrChannel> channels = new ArrayList<>();
        for (String name : names) {
            float[] values = new float[2 * rows];
            Arrays.fill(values, value);
            channels.add(new ExrChannel(name, values, 0, 1));
        }
        Path file = folder.resolve("noisy.exr");
        ExrWriter.write(
                file,
                new ExrPicture(2, 3, firstRow, rows, channels, Optional.of(new Provenance("Twister", "picture", "4"))));
        return file;
    }

    private static float value(Path file, String channel) throws IOException {
        return ExrReader.read(file).channels().stream()
                .filter(each -> each.name().equals(channel))
                .findFirst()
                .orElseThrow()
                .values()[0];
    }
}
