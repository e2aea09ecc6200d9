package dev.twister.cli.file;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import dev.twister.cli.Outcome;
import dev.twister.denoise.FakeDenoiser;
import dev.twister.image.ExrPicture;
import dev.twister.image.ExrReader;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.ExtendWith;
import org.junit.jupiter.api.io.TempDir;

/** {@code render --denoise} and {@code join --denoise} with a denoiser whose sum shows what it was given. */
@ExtendWith(FakeDenoiser.Offered.class)
class RenderDenoisedTest {
    @TempDir
    private Path folder;

    @Test
    void anExrFileHasDenoisedNoisyAndGuidesAsLayers() throws IOException {
        ExrPicture picture = render("--denoise", "-o", file("a.exr"));

        assertThat(value(picture, "R"))
                .isCloseTo(
                        value(picture, "noisy.R")
                                + 10 * value(picture, "guide-albedo.R")
                                + 100 * value(picture, "guide-normal.X"),
                        within(1e-3f));
    }

    @Test
    void otherViewsStayAsTheyAre() throws IOException {
        ExrPicture plain = render("--view", "beauty,depth", "-o", file("a.exr"));
        ExrPicture denoised = render("--view", "beauty,depth", "--denoise", "-o", file("b.exr"));

        assertThat(value(denoised, "depth.Z")).isEqualTo(value(plain, "depth.Z"));
        assertThat(value(denoised, "noisy.R")).isEqualTo(value(plain, "R"));
    }

    @Test
    void pixelsAreToned() throws IOException {
        Outcome noisy = outcome("-o", file("noisy.png"));
        Outcome denoised = outcome("--denoise", "-o", file("clean.png"));

        assertThat(noisy.exitCode()).isZero();
        assertThat(denoised.exitCode()).isZero();
        assertThat(Files.readAllBytes(folder.resolve("clean.png")))
                .isNotEqualTo(Files.readAllBytes(folder.resolve("noisy.png")));
    }

    @Test
    void joinedRangesAreDenoisedWithTheirGuides() throws IOException {
        render("--guides", "--sample-range", "0-1", "-o", file("1.exr"));
        render("--guides", "--sample-range", "2-3", "-o", file("2.exr"));
        Outcome joined = Outcome.of("join", file("1.exr"), file("2.exr"), "--denoise", "-o", file("joined.exr"));
        ExrPicture picture = ExrReader.read(folder.resolve("joined.exr"));

        assertThat(joined.exitCode()).isZero();
        assertThat(value(picture, "R"))
                .isCloseTo(
                        value(picture, "noisy.R")
                                + 10 * value(picture, "guide-albedo.R")
                                + 100 * value(picture, "guide-normal.X"),
                        within(1e-3f));
    }

    @Test
    void framesAreDenoised() throws IOException {
        Outcome outcome = outcome("--turntable", "1", "--fps", "2", "--denoise", "-o", file("f-####.exr"));
        ExrPicture second = ExrReader.read(folder.resolve("f-0001.exr"));

        assertThat(outcome.exitCode()).isZero();
        assertThat(value(second, "R")).isNotEqualTo(value(second, "noisy.R"));
    }

    @Test
    void partsAreNotDenoised() {
        Outcome outcome = outcome("--denoise", "--tile", "1/2", "-o", file("a.exr"));

        assertThat(outcome.exitCode()).isEqualTo(ExitCode.BAD_INPUT);
        assertThat(outcome.err()).contains("--denoise needs the whole picture");
    }

    @Test
    void viewsAloneAreNotDenoised() {
        Outcome outcome = outcome("--denoise", "--view", "depth", "-o", file("a.exr"));

        assertThat(outcome.exitCode()).isEqualTo(ExitCode.BAD_INPUT);
        assertThat(outcome.err()).contains("--denoise needs the full picture");
    }

    @Test
    void guidesNeedAnExrFile() {
        Outcome outcome = outcome("--guides", "-o", file("a.png"));

        assertThat(outcome.exitCode()).isEqualTo(ExitCode.BAD_INPUT);
        assertThat(outcome.err()).contains("--guides needs an .exr file");
    }

    private ExrPicture render(String... arguments) throws IOException {
        Outcome outcome = outcome(arguments);
        assertThat(outcome.err()).isEmpty();
        return ExrReader.read(Path.of(arguments[arguments.length - 1]));
    }

    private static Outcome outcome(String... arguments) {
        List<String> all = new ArrayList<>(List.of("render", "cornell", "--engine", "sequential", "--size", "12x12"));
        if (!List.of(arguments).contains("--sample-range")) {
            all.addAll(List.of("--samples", "2"));
        }
        all.addAll(List.of(arguments));
        return Outcome.of(all.toArray(String[]::new));
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
