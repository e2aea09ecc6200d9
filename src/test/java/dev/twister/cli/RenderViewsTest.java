package dev.twister.cli;

import static org.assertj.core.api.Assertions.assertThat;

import dev.twister.image.ExrFile;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Renders stages and views, from the command line to the file. */
class RenderViewsTest {
    @TempDir
    private Path folder;

    @Test
    void stagesLeadToThePicture() throws IOException {
        List<List<Integer>> pictures = new ArrayList<>();
        for (String stage : List.of("colors", "diffuse", "highlights", "hard-shadows", "Soft-Shadows", "reflections")) {
            pictures.add(pixels("stage.png", "--stage", stage));
        }

        assertThat(new HashSet<>(pictures)).hasSize(pictures.size());
        assertThat(pictures.getLast()).isEqualTo(pixels("picture.png"));
        assertThat(pictures.get(4)).isEqualTo(pixels("picture.png", "--bounces", "0"));
        assertThat(pictures.get(3)).isEqualTo(pixels("picture.png", "--bounces", "0", "--shadow-samples", "1"));
    }

    /** The center pixel shows a sphere, the corner the sky. */
    @ParameterizedTest
    @ValueSource(strings = {"albedo", "normal", "depth", "body", "bounces", "tests"})
    void viewsTellBodiesFromTheSky(String view) throws IOException {
        List<Integer> pixels = pixels("view.png", "--view", view);

        assertThat(pixels.getFirst()).isNotEqualTo(pixels.get(32 * 9 + 16));
        if (!view.equals("tests")) {
            assertThat(pixels.getFirst()).isEqualTo(0xFF000000);
        }
    }

    /** Exposure does not apply to views of numbers, which have their own scale; albedo is a color. */
    @Test
    void exposureChangesColorsAlone() throws IOException {
        for (String view : List.of("normal", "depth", "body", "shadow", "bounces", "tests")) {
            assertThat(pixels("view.png", "--view", view, "--exposure", "1"))
                    .isEqualTo(pixels("view.png", "--view", view));
        }
        assertThat(pixels("view.png", "--view", "albedo", "--exposure", "1"))
                .isNotEqualTo(pixels("view.png", "--view", "albedo"));
    }

    @Test
    @EnabledOnOs(value = OS.LINUX, architectures = "amd64")
    void viewsAreLayersOfOneFile() throws IOException {
        String views = "beauty,normal,depth,albedo,body,shadow,bounces,tests";
        ExrFile layers = exr("layers.exr", "--view", views);

        assertThat(layers.channels().keySet())
                .isEqualTo(Set.of(
                        "R",
                        "G",
                        "B",
                        "normal.R",
                        "normal.G",
                        "normal.B",
                        "depth.Z",
                        "albedo.R",
                        "albedo.G",
                        "albedo.B",
                        "body.Y",
                        "shadow.Y",
                        "bounces.Y",
                        "tests.Y"));
        assertThat(layers.width()).isEqualTo(32);
        assertThat(layers.height()).isEqualTo(18);
        assertThat(layers.channels().get("R"))
                .isEqualTo(exr("plain.exr").channels().get("R"));
        assertThat(layers.channels().get("depth.Z"))
                .isEqualTo(exr("depth.exr", "--view", "depth").channels().get("Y"));
        assertThat(layers.channels().get("albedo.G"))
                .isEqualTo(exr("albedo.exr", "--view", "albedo").channels().get("G"));
        assertThat(layers.channels().get("body.Y")[0]).isEqualTo(-1);
        assertThat(layers.channels().get("tests.Y")[0]).isEqualTo(7);
    }

    @Test
    void aSingleViewMayBeARadianceFile() {
        assertThat(render("view.hdr", "--view", "depth").err()).isEmpty();
        assertThat(folder.resolve("view.hdr")).isNotEmptyFile();
    }

    @Test
    void framesOfMovingBodiesHaveViewsToo() {
        Outcome outcome = render("f.exr", "--view", "normal,depth", "--physics", "--frames", "2");
        assertThat(outcome.err()).isEmpty();
        assertThat(folder.toFile().list()).containsExactlyInAnyOrder("f-0000.exr", "f-0001.exr");
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "a.png | --stage shadows | unknown value 'shadows'; expected one of: colors, diffuse, highlights, hard-shadows",
                "a.png | --stage depth | unknown value 'depth'",
                "a.png | --view diffuse | unknown value 'diffuse'; expected one of: beauty, albedo, normal, depth, body",
                "a.png | --view normal,depth | --view has 2 names, which only an .exr file can hold",
                "a.exr | --view normal,normal | --view has the same name twice",
                "a.exr | --view normal --stage colors | --stage and --view exclude each other"
            })
    void whatCannotBeRenderedIsSaid(String file, String options, String message) {
        Outcome outcome = render(file, options.split(" "));
        assertThat(outcome.exitCode()).isEqualTo(2);
        assertThat(outcome.err()).contains(message);
        assertThat(folder).isEmptyDirectory();
    }

    private List<Integer> pixels(String name, String... options) throws IOException {
        Outcome outcome = render(name, options);
        assertThat(outcome.err()).isEmpty();
        BufferedImage picture = ImageIO.read(folder.resolve(name).toFile());
        List<Integer> pixels = new ArrayList<>();
        for (int pixel = 0; pixel < 32 * 18; pixel++) {
            pixels.add(picture.getRGB(pixel % 32, pixel / 32));
        }
        return pixels;
    }

    private ExrFile exr(String name, String... options) throws IOException {
        assertThat(render(name, options).err()).isEmpty();
        return ExrFile.read(folder.resolve(name));
    }

    private Outcome render(String name, String... options) {
        List<String> arguments = new ArrayList<>(List.of(
                "render",
                "benchmark",
                "-o",
                folder.resolve(name).toString(),
                "--size",
                "32x18",
                "--engine",
                "sequential"));
        arguments.addAll(List.of(options));
        return Outcome.of(arguments.toArray(String[]::new));
    }
}
