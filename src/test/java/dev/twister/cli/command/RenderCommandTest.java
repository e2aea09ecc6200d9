package dev.twister.cli.command;

import static org.assertj.core.api.Assertions.assertThat;

import dev.twister.ChildJvm;
import dev.twister.cli.Main;
import dev.twister.cli.Outcome;
import dev.twister.cli.file.ExitCode;
import dev.twister.cli.file.SkyFiles;
import dev.twister.engine.ExposureMeter;
import dev.twister.image.PngWriter;
import dev.twister.scene.Scene;
import dev.twister.scene.format.SceneReader;
import dev.twister.world.World;
import java.awt.image.BufferedImage;
import java.io.BufferedReader;
import java.io.IOException;
import java.io.PrintWriter;
import java.io.Writer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class RenderCommandTest {
    @TempDir
    private Path folder;

    @Test
    void drawsAShippedSceneByName() throws IOException {
        Path file = folder.resolve("picture.PNG");

        Outcome outcome = render("benchmark", file, "--size", "48x27");

        assertThat(outcome.err()).isEmpty();
        assertThat(outcome.exitCode()).isZero();
        assertThat(outcome.out()).startsWith(file + ": 48 x 27, auto took ").endsWith(" ms" + System.lineSeparator());
        BufferedImage picture = ImageIO.read(file.toFile());
        assertThat(picture.getWidth()).isEqualTo(48);
        assertThat(picture.getHeight()).isEqualTo(27);
    }

    @Test
    void outputsThatCannotBeMadeAreRefusedBeforeAnythingIsRead() throws IOException {
        Path scene = Files.writeString(folder.resolve("broken.json"), "no scene");
        Path file = folder.resolve("x".repeat(252) + ".png");

        for (String[] options : new String[][] {{}, {"--turntable", "1", "--fps", "2"}}) {
            Outcome outcome = render(scene.toString(), file, options);

            assertThat(outcome.exitCode()).isEqualTo(ExitCode.BAD_INPUT);
            assertThat(outcome.err()).startsWith("twister: --output is " + file).hasLineCount(1);
        }
        assertThat(folder.toFile().list()).containsExactly("broken.json");
    }

    @Test
    void drawsNumberedFramesOfBodiesThatMove() throws IOException {
        Path file = folder.resolve("fall.png");

        Outcome outcome = render(
                "pour-1000",
                file,
                "--size",
                "48x27",
                "--engine",
                "sequential",
                "--shadow-samples",
                "1",
                "--physics",
                "--frames",
                "3",
                "--fps",
                "10",
                "--start",
                "0.9");

        assertThat(outcome.err()).isEmpty();
        assertThat(outcome.exitCode()).isZero();
        Path first = folder.resolve("fall-0000.png");
        Path last = folder.resolve("fall-0002.png");
        assertThat(outcome.out()).startsWith(first + " to " + last + ": 3 frames of 48 x 27, ");
        assertThat(folder.toFile().list()).containsExactlyInAnyOrder("fall-0000.png", "fall-0001.png", "fall-0002.png");
        assertThat(Files.readAllBytes(first)).isNotEqualTo(Files.readAllBytes(last));

        Path alone = folder.resolve("alone.png");
        Outcome one = render(
                "pour-1000",
                alone,
                "--size",
                "48x27",
                "--engine",
                "sequential",
                "--shadow-samples",
                "1",
                "--physics",
                "--start",
                "1.1");
        assertThat(one.exitCode()).isZero();
        assertThat(alone).hasSameBinaryContentAs(last);
    }

    @ParameterizedTest
    @CsvSource({
        "fall-%04d.png, fall-0001.png",
        "fall.####.png, fall.0001.png",
        "#.png, 1.png",
        "%d fall.png, 1 fall.png",
        "%02d-100%.png, 01-100%.png",
        "100%.png, 100%-0001.png"
    })
    void framesHaveTheirNumberWhereTheNameSays(String name, String second) {
        Outcome outcome = drawFrames(folder.resolve(name));

        assertThat(outcome.err()).isEmpty();
        assertThat(outcome.exitCode()).isZero();
        assertThat(folder.resolve(second)).isRegularFile();
    }

    @Test
    void framesOfAnEarlierRunAreReplacedOnDemandOnly() throws IOException {
        Path file = folder.resolve("fall.png");
        Path second = Files.writeString(folder.resolve("fall-0001.png"), "older");

        Outcome refused = drawFrames(file);
        assertThat(refused.exitCode()).isEqualTo(2);
        assertThat(refused.err())
                .startsWith("twister: " + second + " already exists")
                .contains("--overwrite")
                .hasLineCount(1);
        assertThat(second).hasContent("older");
        assertThat(folder.resolve("fall-0000.png")).doesNotExist();

        assertThat(drawFrames(file, "--overwrite").exitCode()).isZero();
        assertThat(ImageIO.read(second.toFile())).isNotNull();
    }

    @Test
    void aMinusWritesThePictureToTheStandardOutput() throws IOException, InterruptedException {
        Process java = ChildJvm.start(ChildJvm.of(
                        Main.class,
                        "render",
                        "benchmark",
                        "-o",
                        "-",
                        "--size",
                        "48x27",
                        "--shadow-samples",
                        "1",
                        "--engine",
                        "sequential")
                .directory(folder.toFile()));
        byte[] written = java.getInputStream().readAllBytes();
        try (BufferedReader err = java.errorReader(StandardCharsets.UTF_8)) {
            assertThat(err.readAllAsString()).startsWith("standard output: 48 x 27, sequential ");
        }

        assertThat(java.waitFor()).isZero();
        assertThat(folder).isEmptyDirectory();
        assertThat(written)
                .isEqualTo(bytes("same.png", "--size", "48x27", "--shadow-samples", "1", "--engine", "sequential"));
    }

    private Outcome drawFrames(Path file, String... more) {
        List<String> options = new ArrayList<>(List.of(
                "--size", "8x8", "--engine", "sequential", "--shadow-samples", "1", "--physics", "--frames", "2"));
        options.addAll(List.of(more));
        return render("benchmark", file, options.toArray(String[]::new));
    }

    @Test
    void refusesFramesOfBodiesThatStandStill() {
        Outcome outcome = render("benchmark", folder.resolve("picture.png"), "--frames", "3");
        assertThat(outcome.exitCode()).isEqualTo(2);
        assertThat(outcome.err())
                .startsWith("twister: --frames requires --physics, --motion, --turntable, or a scene with keyframes");
    }

    @Test
    void takesAllOptions() {
        Outcome outcome = render(
                "teaching",
                folder.resolve("picture.png"),
                "--size",
                "17x3",
                "--engine",
                "sequential",
                "--shadow-samples",
                "3",
                "--bounces",
                "0",
                "--samples",
                "4",
                "--exposure",
                "-1.5",
                "--tone-map",
                "aces",
                "--srgb",
                "--sky-rotation",
                "-90",
                "--sky-strength",
                "0.5",
                "--camera",
                "-1,-5,-15",
                "--yaw",
                "-30",
                "--pitch",
                "5",
                "--fov",
                "60");

        assertThat(outcome.err()).isEmpty();
        assertThat(outcome.exitCode()).isZero();
    }

    @Test
    void optionsChangeThePicture() throws IOException {
        byte[] plain = bytes("plain.png");

        assertThat(bytes("exposed.png", "--exposure", "1")).isNotEqualTo(plain);
        assertThat(bytes("curved.png", "--srgb")).isNotEqualTo(plain);
        assertThat(bytes("turned.png", "--yaw", "20")).isNotEqualTo(plain);
        assertThat(bytes("flat.png", "--projection", "orthographic", "--view-height", "9"))
                .isNotEqualTo(bytes("flatter.png", "--projection", "orthographic", "--view-height", "8"));
        assertThat(bytes("wide.png", "--projection", "fisheye", "--fov", "200")).isNotEqualTo(plain);
        assertThat(bytes("sky.png", "--sky-rotation", "20")).isNotEqualTo(plain);
        assertThat(bytes("sky-again.png", "--sky-rotation", "360")).isEqualTo(plain);
        assertThat(bytes("dark.png", "--sky-strength", "0")).isNotEqualTo(plain);
        assertThat(bytes("same.png", "--no-srgb")).isEqualTo(plain);
    }

    @Test
    void anExposureOfAutoIsThatOfTheMeter() throws IOException {
        Scene scene = SceneReader.read(Path.of("scenes", "benchmark.json"));
        World world = SkyFiles.world(scene, new PrintWriter(Writer.nullWriter()));
        world.setSettings(scene.rendering().withSize(32, 18));
        double stops = ExposureMeter.stops(world.snapshot()).orElseThrow();

        byte[] metered = bytes("auto.png", "--exposure", "auto");

        assertThat(metered)
                .isEqualTo(bytes("stops.png", "--exposure", String.valueOf(stops)))
                .isNotEqualTo(bytes("plain.png"));
    }

    @Test
    void anImagesSkyComesBackAsItIs() throws IOException {
        PngWriter.write(folder.resolve("gray.png"), 1, 1, new int[] {0x808080}, true);
        Path scene = Files.writeString(folder.resolve("gray.json"), """
                {"version": 1,
                 "camera": {"position": [0, 0, 0], "yaw": 0, "pitch": 0, "fieldOfView": 60},
                 "light": {"position": [0, -900, 0], "radius": 0.001, "color": [1, 1, 1]},
                 "plane": {"size": 0.001, "height": -900, "colors": [[0, 0, 0], [0, 0, 0]], "reflectivity": 0},
                 "skybox": "gray.png", "spheres": []}
                """);
        Path picture = folder.resolve("picture.png");

        assertThat(render(scene.toString(), picture, "--size", "3x2").exitCode())
                .isZero();

        BufferedImage read = ImageIO.read(picture.toFile());
        assertThat(read.getRGB(1, 1)).isEqualTo(0xFF808080);
    }

    @Test
    void anHdrFileKeepsRadiance() throws IOException {
        Path file = folder.resolve("picture.hdr");

        assertThat(render("benchmark", file, "--size", "32x18").exitCode()).isZero();
        assertThat(Files.readString(file, StandardCharsets.ISO_8859_1))
                .startsWith("#?RADIANCE\nFORMAT=32-bit_rle_rgbe\nSOFTWARE=Twister ")
                .contains("\n\n-Y 18 +X 32\n");
    }

    @Test
    void bandsMakeTheSamePictureAsOneStroke() throws IOException {
        // At 64 view rays per pixel, 200 rows of 300 columns make four bands, the last one shorter.
        byte[] banded =
                bytes("banded.png", "--size", "300x200", "--samples", "64", "--shadow-samples", "1", "--bounces", "0");
        byte[] sequential = bytes(
                "sequential.png",
                "--size",
                "300x200",
                "--samples",
                "64",
                "--shadow-samples",
                "1",
                "--bounces",
                "0",
                "--engine",
                "sequential");

        assertThat(banded).isEqualTo(sequential);
        BufferedImage picture = ImageIO.read(folder.resolve("banded.png").toFile());
        assertThat(picture.getRGB(150, 199)).isNotEqualTo(0xff000000);
    }

    @Test
    void tellsTheNoiseThatIsLeft() {
        Path file = folder.resolve("noise.png");
        assertThat(render("weekend", file, "--size", "32x18", "--noise", "0.1").out())
                .containsPattern("[1-9][0-9]+,? samples per pixel, noise 0\\.0[0-9]+\\R$");
        assertThat(render("weekend", file, "--size", "32x18", "--noise", "0.001", "--samples", "16")
                        .out())
                .containsPattern("16 samples per pixel, noise 0\\.[0-9]+; raise --samples to reach 0\\.001\\R$");
    }

    @Test
    void quietRowsGetFewerSamples() {
        Path file = folder.resolve("bands.png");
        assertThat(render(
                                "juggling",
                                folder.resolve("f-####.png"),
                                "--size",
                                "32x18",
                                "--noise",
                                "0.1",
                                "--frames",
                                "0-1")
                        .out())
                .containsPattern("2 frames of .* samples per pixel, noise 0\\.[0-9]+\\R$");
        String[] options = "--size 1280x64 --noise 0.03 --shadow-samples 1 --bounces 2".split(" ");

        assertThat(render("metals", file, options).out())
                .containsPattern(
                        ", 18 to [1-9][0-9]+, on average [1-9][0-9], samples per pixel, noise 0\\.0[0-9]+\\R$");
    }

    private byte[] bytes(String name, String... options) throws IOException {
        Path file = folder.resolve(name);
        String[] sized = new String[options.length + 2];
        sized[0] = "--size";
        sized[1] = "32x18";
        System.arraycopy(options, 0, sized, 2, options.length);
        String[] used = options.length > 0 && options[0].equals("--size") ? options : sized;
        Outcome outcome = render("benchmark", file, used);
        assertThat(outcome.err()).isEmpty();
        return Files.readAllBytes(file);
    }

    private static Outcome render(String scene, Path file, String... options) {
        String[] arguments = new String[options.length + 4];
        arguments[0] = "render";
        arguments[1] = scene;
        arguments[2] = "-o";
        arguments[3] = file.toString();
        System.arraycopy(options, 0, arguments, 4, options.length);
        return Outcome.of(arguments);
    }
}
