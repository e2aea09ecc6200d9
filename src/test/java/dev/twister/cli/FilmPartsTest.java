package dev.twister.cli;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import dev.twister.engine.Engine;
import dev.twister.engine.Engines;
import dev.twister.image.ExrPicture;
import dev.twister.image.ExrPicture.ExrChannel;
import dev.twister.image.ExrReader;
import dev.twister.image.Frame;
import dev.twister.render.BandedDrawing;
import dev.twister.render.PicturePart;
import dev.twister.render.RenderProgress;
import dev.twister.render.Sampling;
import dev.twister.scene.Scene;
import dev.twister.scene.format.SceneReader;
import dev.twister.world.FrameInput;
import dev.twister.world.SceneImages;
import dev.twister.world.World;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Optional;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestInstance;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

@TestInstance(TestInstance.Lifecycle.PER_CLASS)
class FilmPartsTest {
    private static final int HEIGHT = 23;
    private static final Sampling SAMPLING = new Sampling(2, Optional.empty());

    @TempDir
    private Path folder;

    private Engine engine;
    private FrameInput input;
    private Frame whole;

    @BeforeAll
    void drawTheWhole() {
        Scene scene = SceneReader.read(Path.of("scenes", "glass.json"));
        World world = World.of(scene, SceneImages.read(scene, _ -> {}));
        world.setSettings(scene.rendering()
                .withSize(34, HEIGHT)
                .withShadowSamples(2)
                .withBounces(2)
                .withSamplesPerPixel(2));
        input = world.snapshot();
        engine = Engines.open("vector");
        whole = draw(input);
    }

    @AfterAll
    void close() {
        engine.close();
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 2, 7, HEIGHT})
    void tilesHaveTheBitsOfTheWhole(int tiles) {
        int next = 0;
        for (int number = 1; number <= tiles; number++) {
            PicturePart.Tile tile = new PicturePart.Tile(number, tiles);
            assertThat(tile.firstRow(HEIGHT)).isEqualTo(next);
            int rows = tile.rows(HEIGHT);
            Frame drawn = draw(input.band(next, rows));
            assertThat(drawn.radiance())
                    .as("tile %d of %d", number, tiles)
                    .isEqualTo(whole.rows(next, rows).radiance());
            next += rows;
        }
        assertThat(next).isEqualTo(HEIGHT);
    }

    private Frame draw(FrameInput part) {
        return BandedDrawing.draw(engine, part, SAMPLING, true, RenderProgress.SILENT)
                .frame();
    }

    @Test
    void joinedTilesAreTheWholeFile() throws IOException {
        Path all = render("whole.exr");
        Path top = render("top.exr", "--tile", "1/2");
        Path bottom = render("bottom.exr", "--tile", "2/2");
        Path joined = folder.resolve("joined.exr");

        Outcome outcome = Outcome.of("join", bottom.toString(), top.toString(), "-o", joined.toString());

        assertThat(outcome.err()).isEmpty();
        assertThat(joined).hasSameBinaryContentAs(all);
        assertThat(Outcome.of("join", top.toString(), "-o", joined.toString()).err())
                .startsWith("twister: the parts lack row 9 of 18");
        assertThat(Outcome.of("join", top.toString(), top.toString(), "-o", joined.toString())
                        .err())
                .contains("both have samples");
    }

    @Test
    void joinedRangesAreThePictureOfAllTheirSamples() throws IOException {
        Path all = render("eight.exr", "--samples", "8");
        Path first = render("four.exr", "--sample-range", "0-3");
        Path rest = render("others.exr", "--sample-range", "4-7");
        Path joined = folder.resolve("both.exr");

        assertThat(Outcome.of("join", first.toString(), rest.toString(), "-o", joined.toString())
                        .err())
                .isEmpty();

        ExrPicture expected = ExrReader.read(all);
        ExrPicture mean = ExrReader.read(joined);
        for (int channel = 0; channel < 3; channel++) {
            float[] values = expected.channels().get(channel).values();
            for (int i = 0; i < values.length; i++) {
                assertThat(mean.channels().get(channel).values()[i])
                        .isCloseTo(values[i], within(8 * Math.ulp(values[i])));
            }
        }
    }

    @Test
    void joinedRangesOfSamplesAreTheWholeRange() throws IOException {
        Path all = render("all.exr", "--sample-range", "0-7");
        Path first = render("first.exr", "--sample-range", "0-2");
        Path rest = render("rest.exr", "--sample-range", "3-7");
        Path joined = folder.resolve("mean.exr");

        Outcome outcome = Outcome.of("join", rest.toString(), first.toString(), "-o", joined.toString());

        assertThat(outcome.err()).isEmpty();
        assertThat(outcome.out()).contains("samples: 0-7");
        ExrPicture expected = ExrReader.read(all);
        ExrPicture mean = ExrReader.read(joined);
        assertThat(mean.provenance()).isEqualTo(expected.provenance());
        for (int channel = 0; channel < 3; channel++) {
            ExrChannel values = expected.channels().get(channel);
            for (int i = 0; i < values.values().length; i++) {
                assertThat(mean.channels().get(channel).values()[i])
                        .isCloseTo(values.values()[i], within(8 * Math.ulp(values.values()[i])));
            }
        }
        assertThat(Outcome.of(
                                "join",
                                first.toString(),
                                render("other.exr", "--sample-range", "3-7", "--bounces", "0")
                                        .toString(),
                                "-o",
                                joined.toString())
                        .err())
                .contains("is a part of another picture");
    }

    @Test
    void aPartNeedsAFileThatKeepsAllDigits() {
        Outcome outcome =
                Outcome.of("render", "benchmark", "-o", folder.resolve("a.png").toString(), "--tile", "1/2");

        assertThat(outcome.exitCode()).isEqualTo(2);
        assertThat(outcome.err()).contains("need an .exr file").hasLineCount(1);
        assertThat(Outcome.of(
                                "render",
                                "benchmark",
                                "--size",
                                "8x8",
                                "-o",
                                folder.resolve("a.exr").toString(),
                                "--tile",
                                "1/9")
                        .err())
                .contains("the number of tiles of --tile is 9, but must be from 1 to 8");
    }

    private Path render(String name, String... options) throws IOException {
        Path file = folder.resolve(name);
        String[] arguments = {
            "render",
            "benchmark",
            "-o",
            file.toString(),
            "--size",
            "32x18",
            "--engine",
            "sequential",
            "--shadow-samples",
            "2"
        };
        String[] all = Arrays.copyOf(arguments, arguments.length + options.length);
        System.arraycopy(options, 0, all, arguments.length, options.length);
        Outcome outcome = Outcome.of(all);
        assertThat(outcome.err()).isEmpty();
        assertThat(Files.exists(file)).isTrue();
        return file;
    }
}
