package dev.twister.cli;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import dev.twister.denoise.FakeDenoiser;
import dev.twister.image.AlphaChannel;
import dev.twister.image.ExrPicture;
import dev.twister.image.ExrReader;
import dev.twister.render.PictureLayers;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.ExtendWith;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** {@code twister render --background none}: files with alpha. */
@ExtendWith(FakeDenoiser.Offered.class)
class CutOutTest {
    private static final int WIDTH = 32;
    private static final int PIXELS = WIDTH * 18;

    @TempDir
    private Path folder;

    @ParameterizedTest
    @ValueSource(
            strings = {
                "--samples 4",
                "--samples 4 --integrator path",
                "--samples 64 --integrator path --noise 0.05",
                "--samples 4 --integrator path --denoise"
            })
    void colorsAreMultipliedByAlphaInExrAlone(String options) throws IOException {
        ExrPicture exr = ExrReader.read(render("a.exr", options));
        BufferedImage png = read(render("a.png", options));

        AlphaChannel alpha = AlphaChannel.of(exr).orElseThrow();
        float[] colors = PictureLayers.of(exr, PictureLayers.COLORS).orElseThrow();
        assertThat(alphas(png)).contains(0, 255).anyMatch(value -> value > 20 && value < 235);
        for (int pixel = 0; pixel < PIXELS; pixel++) {
            float part = alpha.values()[alpha.first() + pixel * alpha.stride()];
            int argb = png.getRGB(pixel % WIDTH, pixel / WIDTH);
            assertThat(argb >>> 24).isCloseTo(Math.round(255 * part), within(1));
            float green = part > 0 ? Math.min(1, colors[3 * pixel + 1] / part) : 0;
            assertThat(linear(argb >> 8 & 0xFF)).isCloseTo(green, within(0.01f));
        }
    }

    @Test
    void rangesOfSamplesAreJoined() throws IOException {
        BufferedImage whole = read(render("whole.png", "--integrator path --samples 6"));
        Path first = render("first.exr", "--integrator path --sample-range 0-1");
        Path second = render("second.exr", "--integrator path --sample-range 2-5");
        Path joined = folder.resolve("joined.png");

        Outcome outcome = Outcome.of("join", first.toString(), second.toString(), "-o", joined.toString());

        assertThat(outcome.err()).isEmpty();
        BufferedImage picture = read(joined);
        for (int pixel = 0; pixel < PIXELS; pixel++) {
            for (int shift = 0; shift < 32; shift += 8) {
                int value = picture.getRGB(pixel % WIDTH, pixel / WIDTH) >>> shift & 0xFF;
                assertThat(value).isCloseTo(whole.getRGB(pixel % WIDTH, pixel / WIDTH) >>> shift & 0xFF, within(1));
            }
        }
    }

    @Test
    void filmsAreTransparent() throws IOException {
        String turn = "--turntable 2 --frames 2 --fps 1 --samples 2 --integrator path";
        Path film = render("film.apng", turn);
        Path frame = render("frame-#.png", turn).resolveSibling("frame-0.png");
        Path joined = folder.resolve("joined.apng");
        Outcome outcome =
                Outcome.of("film", folder.resolve("frame-#.png").toString(), "-o", joined.toString(), "--fps", "1");

        assertThat(outcome.err()).isEmpty();
        assertThat(joined).hasSameBinaryContentAs(film);
        assertThat(alphas(read(film))).contains(0, 255).isEqualTo(alphas(read(frame)));
    }

    @Test
    void viewsKeepTheirPlace() throws IOException {
        ExrPicture several = ExrReader.read(render("a.exr", "--view beauty,depth --samples 2"));
        ExrPicture alone = ExrReader.read(render("b.exr", "--samples 2"));

        assertThat(several.channels()).extracting(ExrPicture.ExrChannel::name).contains("A", "depth.Z");
        assertThat(PictureLayers.of(several, List.of("A")))
                .get()
                .isEqualTo(PictureLayers.of(alone, List.of("A")).orElseThrow());
    }

    private Path render(String name, String options) throws IOException {
        Path mesh = Files.writeString(folder.resolve("a.obj"), "v -1 0 0\nv 1 0 0\nv 0 2 0\nf 1 2 3\n");
        Path file = folder.resolve(name);
        List<String> arguments = new ArrayList<>(List.of("render", mesh.toString(), "-o", file.toString()));
        arguments.addAll(List.of("--size", "32x18", "--engine", "sequential", "--background", "none"));
        arguments.addAll(List.of(options.split(" ")));
        Outcome outcome = Outcome.of(arguments.toArray(String[]::new));
        assertThat(outcome.err()).isEmpty();
        return file;
    }

    private static BufferedImage read(Path file) throws IOException {
        return ImageIO.read(file.toFile());
    }

    private static List<Integer> alphas(BufferedImage picture) {
        List<Integer> alphas = new ArrayList<>();
        for (int argb : picture.getRGB(0, 0, picture.getWidth(), picture.getHeight(), null, 0, picture.getWidth())) {
            alphas.add(argb >>> 24);
        }
        return alphas;
    }

    private static float linear(int level) {
        double shown = level / 255.0;
        return (float) (shown <= 0.04045 ? shown / 12.92 : Math.pow((shown + 0.055) / 1.055, 2.4));
    }
}
