package dev.twister.cli;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import dev.twister.engine.Engine;
import dev.twister.engine.Engines;
import dev.twister.image.ExrPicture;
import dev.twister.image.ExrPicture.ExrChannel;
import dev.twister.image.ExrReader;
import dev.twister.image.Frame;
import dev.twister.scene.Integrator;
import dev.twister.scene.Scene;
import dev.twister.scene.format.SceneReader;
import dev.twister.world.Animation;
import dev.twister.world.SceneImages;
import dev.twister.world.SceneMeshes;
import dev.twister.world.World;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import java.util.stream.IntStream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** A ball that flies past a textured ball that turns. */
class MotionBlurTest {
    private static final String SCENE = """
            {"version": 4,
             "camera": {"position": [0, 1.4, -6], "pitch": 4, "fieldOfView": 40},
             "light": {"position": [-4, 6, -4], "radius": 0.5, "color": [1, 1, 1]},
             "plane": {"size": 24, "height": 0, "colors": [[0.6, 0.6, 0.6], [0.3, 0.3, 0.3]], "reflectivity": 10},
             "rendering": {"width": 64, "height": 36, "shadowSamples": 1, "bounces": 1, "samplesPerPixel": 64,
               "shutter": 1},
             "spheres": [{"position": [-2, 1, 0], "radius": 0.5, "color": [0.9, 0.3, 0.1], "reflectivity": 40}],
             "meshes": [{"shape": "icosphere", "size": 2, "position": [1, 1.05, 0], "texture": "TEXTURE"}],
             "tracks": [
               {"target": "spheres[0]", "property": "position", "keyframes": [
                 {"time": 0, "value": [-2.4, 0.6, 0], "easing": "linear"}, {"time": 1, "value": [-0.6, 2.2, 0]}]},
               {"target": "meshes[0]", "property": "rotation", "loop": true, "keyframes": [
                 {"time": 0, "value": [0, 0, 0], "easing": "linear"}, {"time": 1, "value": [360, 0, 0]}]}]}
            """;

    /** Frames per second: the shutter is open for half a second. */
    private static final String RATE = "2";

    private static final int PICTURES = 256;

    /** By integrator; all tests have the same scene. */
    private static final Map<String, float[]> MEANS = new ConcurrentHashMap<>();

    @TempDir
    private Path folder;

    private Path file;

    @BeforeEach
    void write() throws IOException {
        file = folder.resolve("scene.json");
        Path texture = Path.of("scenes", "textures", "earth.png").toAbsolutePath();
        Files.writeString(file, SCENE.replace("TEXTURE", texture.toString().replace('\\', '/')));
    }

    @ParameterizedTest
    @CsvSource({"sequential, whitted, 0.004", "vector, whitted, 0.004", "parallel, path, 0.02", "vector, path, 0.02"})
    void isTheMeanOfManyPictures(String engine, String integrator, double most) throws IOException {
        String[] options = {"--time", "1", "--fps", RATE, "--engine", engine, "--integrator", integrator};
        float[] blurred = radiance(render("blurred.exr", options));
        float[] sharp = radiance(render("sharp.exr", plus(options, "--shutter", "0")));
        float[] mean = MEANS.computeIfAbsent(integrator, this::mean);

        assertThat(difference(blurred, mean)).isLessThan(most);
        assertThat(difference(sharp, mean)).isGreaterThan(0.05);
    }

    /** The mean of pictures of one sample each while the shutter is open, each with its own sample. */
    private float[] mean(String integrator) {
        Scene read = SceneReader.read(file);
        Scene scene = read.withRendering(
                read.rendering().withIntegrator(Integrator.valueOf(integrator.toUpperCase(Locale.ROOT))));
        SceneMeshes meshes = SceneMeshes.read(scene, _ -> {});
        World world = World.of(scene, SceneImages.read(scene, meshes, _ -> {}), meshes);
        Frame frame = Frame.ofRadiance(64, 36);
        float[] mean = new float[frame.radiance().length];
        try (Engine engine = Engines.open("parallel")) {
            for (int picture = 0; picture < PICTURES; picture++) {
                // Samples in another order than the moments, so that places in a pixel and times are independent.
                int sample = 1 + picture * 101 % PICTURES;
                world.show(Animation.at(scene, 0.5 + (picture + 0.5) / PICTURES / 2));
                engine.render(world.snapshot().withSamples(sample, 1), frame);
                for (int i = 0; i < mean.length; i++) {
                    mean[i] += frame.radiance()[i] / PICTURES;
                }
            }
        }
        return mean;
    }

    /** The root mean square of the differences of the means of blocks of 4 x 4 pixels. */
    private static double difference(float[] one, float[] other) {
        double[] blocks = new double[3 * 16 * 9];
        for (int i = 0; i < one.length; i++) {
            int pixel = i / 3;
            blocks[3 * (pixel / 64 / 4 * 16 + pixel % 64 / 4) + i % 3] += (one[i] - other[i]) / 16;
        }
        double squares = IntStream.range(0, blocks.length)
                .mapToDouble(i -> blocks[i] * blocks[i])
                .sum();
        return Math.sqrt(squares / blocks.length);
    }

    @Test
    void partsAreThoseOfTheWhole() throws IOException {
        String[] options = {"--time", "1", "--fps", RATE, "--engine", "sequential"};
        Path whole = render("whole.exr", plus(options, "--sample-range", "0-15"));
        Path first = render("first.exr", plus(options, "--sample-range", "0-6"));
        Path rest = render("rest.exr", plus(options, "--sample-range", "7-15"));
        assertThat(difference(radiance(join("ranges.exr", first, rest)), radiance(whole)))
                .isLessThan(1e-6);

        Path all = render("all.exr", plus(options, "--samples", "6"));
        Path top = render("top.exr", plus(options, "--samples", "6", "--tile", "1/2"));
        Path bottom = render("bottom.exr", plus(options, "--samples", "6", "--tile", "2/2"));
        assertThat(join("tiles.exr", top, bottom)).hasSameBinaryContentAs(all);
    }

    private Path join(String name, Path... parts) {
        Path joined = folder.resolve(name);
        assertThat(Outcome.of("join", parts[0].toString(), parts[1].toString(), "-o", joined.toString())
                        .err())
                .isEmpty();
        return joined;
    }

    @Test
    void framesAreTheSameInEveryRangeAndDependOnTheirWay() throws IOException {
        String[] options = {"--fps", RATE, "--samples", "4", "--engine", "sequential", "--skip-existing"};
        Path frame = folder.resolve("f-0002.png");
        render("f-####.png", plus(options, "--frames", "3"));
        byte[] ofFilm = Files.readAllBytes(frame);
        Files.delete(frame);
        render("f-####.png", plus(options, "--frames", "2-2"));
        assertThat(frame).hasBinaryContent(ofFilm);
        assertThat(out("f-####.png", plus(options, "--frames", "2-2"))).contains("1 kept");

        // At the time of the frame all is the same, but not before it.
        Files.writeString(
                file,
                Files.readString(file)
                        .replace("\"easing\": \"linear\"}, {\"time\": 1", "\"easing\": \"hold\"}, {\"time\": 1"));
        assertThat(Outcome.of(arguments("f-####.png", plus(options, "--frames", "2-2")))
                        .err())
                .contains("differs in its scene");
        assertThat(Outcome.of(arguments("f-####.png", plus(options, "--frames", "2-2", "--shutter", "0.5")))
                        .err())
                .contains("differs in its scene");
    }

    @Test
    void bodiesOfMotionFilesMoveAsInTheSimulation() throws IOException {
        Path motion = folder.resolve("drop.motion");
        Outcome simulated =
                Outcome.of("simulate", file.toString(), "-o", motion.toString(), "--frames", "6", "--fps", "10");
        assertThat(simulated.err()).isEmpty();
        String[] options = {"--frames", "4-5", "--samples", "4", "--engine", "sequential"};
        render("a-####.png", plus(options, "--physics", "--fps", "10"));
        render("b-####.png", plus(options, "--motion", motion.toString()));
        render("c-####.png", plus(options, "--motion", motion.toString(), "--shutter", "0"));

        for (String number : List.of("0004", "0005")) {
            byte[] blurred = Files.readAllBytes(folder.resolve("a-" + number + ".png"));
            assertThat(folder.resolve("b-" + number + ".png")).hasBinaryContent(blurred);
            assertThat(Files.readAllBytes(folder.resolve("c-" + number + ".png")))
                    .isNotEqualTo(blurred);
        }
    }

    @Test
    void aPictureOfPhysicsIsThatOfTheFilm() throws IOException {
        String[] options = {"--physics", "--fps", "10", "--samples", "4", "--engine", "sequential"};
        Files.writeString(file, Files.readString(file).replaceAll("(?s),\\s*\"tracks\".*", "}"));
        render("f-####.exr", plus(options, "--frames", "5-5"));
        Path picture = render("p.exr", plus(options, "--start", "0.5"));

        assertThat(difference(radiance(picture), radiance(folder.resolve("f-0005.exr"))))
                .isLessThan(1e-6);
        assertThat(difference(
                        radiance(picture),
                        radiance(render("s.exr", plus(options, "--start", "0.5", "--shutter", "0")))))
                .isGreaterThan(0.001);
    }

    @Test
    void edgesOfMovingBodiesAreTransparentInPart() throws IOException {
        Path cut = render("cut.exr", "--time", "1", "--fps", RATE, "--background", "none", "--engine", "sequential");
        float[] alpha = channel(cut, "A");

        // Above the plane, where the ball flies.
        int between = 0;
        for (int i = 0; i < 64 * 12; i++) {
            between += alpha[i] > 0.05 && alpha[i] < 0.95 ? 1 : 0;
        }
        assertThat(between).isGreaterThan(60);
    }

    @Test
    void noiseHasItsBound() throws IOException {
        String[] options = {"--time", "1", "--fps", RATE, "--noise", "0.02", "--samples", "512", "--engine", "vector"};
        Path file = render("noise.exr", options);

        assertThat(difference(radiance(file), MEANS.computeIfAbsent("whitted", this::mean)))
                .isLessThan(0.01);
        // Where nothing moves the least number is enough, and what moves needs more.
        float[] samples = channel(file, "samples.Y");
        assertThat(samples[0]).isEqualTo(16f, within(8f));
        assertThat(IntStream.range(0, samples.length)
                        .mapToDouble(i -> samples[i])
                        .max()
                        .orElse(0))
                .isGreaterThan(30);
    }

    @ParameterizedTest
    @ValueSource(strings = {"--shutter 0.5", "--shutter 1.5 --time 1", "--shutter -1 --frames 2"})
    void rejectsAShutter(String options) {
        Outcome outcome = Outcome.of(arguments("a.png", options.split(" ")));

        assertThat(outcome.exitCode()).isEqualTo(2);
        assertThat(outcome.err()).contains("--shutter").hasLineCount(1);
    }

    @Test
    void oneSampleIsTold() {
        assertThat(Outcome.of(arguments("a.png", "--time", "1", "--samples", "1", "--engine", "sequential"))
                        .err())
                .contains("--samples 16")
                .hasLineCount(1);
        assertThat(Outcome.of(arguments("a.png", "--samples", "1", "--engine", "sequential"))
                        .err())
                .isEmpty();
    }

    private static String[] plus(String[] options, String... more) {
        List<String> all = new ArrayList<>(List.of(options));
        all.addAll(List.of(more));
        return all.toArray(String[]::new);
    }

    private Path render(String name, String... options) {
        out(name, options);
        return folder.resolve(name);
    }

    private String out(String name, String... options) {
        Outcome outcome = Outcome.of(arguments(name, options));
        assertThat(outcome.err()).isEmpty();
        return outcome.out();
    }

    private String[] arguments(String name, String... options) {
        return plus(
                new String[] {
                    "render", file.toString(), "-o", folder.resolve(name).toString()
                },
                options);
    }

    private static float[] radiance(Path exr) throws IOException {
        float[] red = channel(exr, "R");
        float[] green = channel(exr, "G");
        float[] blue = channel(exr, "B");
        float[] all = new float[3 * red.length];
        for (int i = 0; i < red.length; i++) {
            all[3 * i] = red[i];
            all[3 * i + 1] = green[i];
            all[3 * i + 2] = blue[i];
        }
        return all;
    }

    private static float[] channel(Path exr, String name) throws IOException {
        ExrPicture picture = ExrReader.read(exr);
        ExrChannel channel = picture.channels().stream()
                .filter(candidate -> candidate.name().equals(name))
                .findFirst()
                .orElseThrow();
        float[] values = new float[picture.width() * picture.rows()];
        for (int i = 0; i < values.length; i++) {
            values[i] = channel.values()[channel.first() + i * channel.stride()];
        }
        return values;
    }
}
