package dev.twister.cli.command;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import dev.twister.ChildJvm;
import dev.twister.bench.benchmark.Jit;
import dev.twister.cli.Main;
import dev.twister.cli.Outcome;
import dev.twister.cli.file.ExitCode;
import dev.twister.image.PngWriter;
import dev.twister.scene.Scene;
import dev.twister.scene.format.SceneReader;
import dev.twister.sky.Skybox;
import dev.twister.sky.SkyboxReader;
import java.io.BufferedReader;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

class CommandsTest {
    private static final Path DAY = Path.of("skyboxes", "day.hdr");

    @TempDir
    private Path folder;

    @Test
    void helpNamesEveryCommand() {
        Outcome outcome = Outcome.of("--help");

        assertThat(outcome.exitCode()).isZero();
        assertThat(outcome.out())
                .contains(
                        "gui",
                        "render",
                        "simulate",
                        "join",
                        "film",
                        "benchmark",
                        "devices",
                        "sky",
                        "scene",
                        "generate-completion");
    }

    @ParameterizedTest
    @ValueSource(strings = {"gui", "render", "simulate", "join", "film", "benchmark", "devices", "sky", "scene"})
    void everyCommandHasHelpWithExamples(String command) {
        Outcome outcome = Outcome.of(command, "--help");

        assertThat(outcome.exitCode()).isZero();
        assertThat(outcome.out()).startsWith("Usage: twister " + command).contains("Example", "  twister " + command);
    }

    @Test
    void tellsItsVersion() {
        assertThat(Outcome.of("--version").out()).startsWith("twister ").contains("JDK " + Runtime.version());
    }

    @Test
    void completesInAShell() {
        assertThat(Outcome.of("generate-completion").out())
                .contains("--shadow-samples", "complete")
                .contains("(\"sequential\"", "\"auto\"", "\"vector\"", "\"tornado\")", "\"spheres-100\"")
                .contains("\"clamp\" \"reinhard\" \"aces\"", "\"day\" \"sunset\" \"overcast\"");
    }

    @Test
    void showsDevices() {
        Outcome outcome = Outcome.of("devices");

        assertThat(outcome.exitCode()).isZero();
        assertThat(outcome.out()).contains("These engines work here:", "sequential", "parallel", "tornado");
    }

    @Test
    void devicesTellThatVectorIsSlowWithGraal() {
        assertThat(DevicesCommand.jitLine(Jit.GRAAL).orElseThrow()).contains("slow", "-XX:-UseJVMCICompiler");
        assertThat(DevicesCommand.jitLine(Jit.C2)).isEmpty();
    }

    @Test
    void makesASky() {
        Path file = folder.resolve("sky.hdr");

        Outcome outcome = Outcome.of("sky", "-o", file.toString(), "--elevation", "8", "--size", "16x8");

        assertThat(outcome.err()).isEmpty();
        assertThat(outcome.exitCode()).isZero();
        Skybox sky = SkyboxReader.read(file);
        assertThat(sky.width()).isEqualTo(16);
        assertThat(sky.height()).isEqualTo(8);
    }

    @Test
    void makesASceneThatIsValid() {
        Path file = folder.resolve("scene.json");

        Outcome made = Outcome.of("scene", "--spheres", "12", "--seed", "7", "-o", file.toString());
        assertThat(made.err()).isEmpty();
        assertThat(made.exitCode()).isZero();
        Scene scene = SceneReader.read(file);
        assertThat(scene.spheres()).hasSize(12);

        Outcome checked = Outcome.of("scene", "--check", file.toString());
        assertThat(checked.err()).isEmpty();
        assertThat(checked.out()).contains("valid, 12 spheres");
    }

    @Test
    void writesASceneToStandardOutput() throws IOException {
        Outcome made = Outcome.of("scene", "--spheres", "3", "-o", "-");

        assertThat(made.err()).isEmpty();
        assertThat(Path.of("-")).doesNotExist();
        Path file = Files.writeString(folder.resolve("scene.json"), made.out());
        assertThat(SceneReader.readWithoutPictures(file).spheres()).hasSize(3);
    }

    @Test
    void readsASceneFromStandardInput() throws IOException, InterruptedException {
        Process java = ChildJvm.start(ChildJvm.of(Main.class, "scene", "--check", "-"));
        try (OutputStream in = java.getOutputStream()) {
            in.write("{\"version\": 1,".getBytes(StandardCharsets.UTF_8));
        }
        try (BufferedReader err = java.errorReader(StandardCharsets.UTF_8)) {
            assertThat(err.readAllAsString()).startsWith("twister: standard input:1:15: not valid JSON");
        }
        assertThat(java.waitFor()).isEqualTo(ExitCode.BAD_INPUT);
    }

    @Test
    void writesAPanoramaToStandardOutput() throws IOException, InterruptedException {
        Process java = ChildJvm.start(ChildJvm.of(Main.class, "sky", "-o", "-", "--size", "8x4"));
        byte[] written = java.getInputStream().readAllBytes();
        try (BufferedReader err = java.errorReader(StandardCharsets.UTF_8)) {
            assertThat(err.readAllAsString()).isEqualToIgnoringNewLines("standard output: 8 x 4");
        }
        assertThat(java.waitFor()).isZero();
        Path file = folder.resolve("sky.hdr");
        assertThat(Outcome.of("sky", "-o", file.toString(), "--size", "8x4").exitCode())
                .isZero();
        assertThat(file).hasBinaryContent(written);
    }

    @Test
    void quietCommandsPrintErrorsAlone() {
        Outcome made = Outcome.of(
                "scene", "--spheres", "3", "-o", folder.resolve("scene.json").toString(), "--quiet");
        assertThat(made).isEqualTo(new Outcome(ExitCode.OK, "", ""));

        Outcome failed =
                Outcome.of("scene", "--check", folder.resolve("none.json").toString(), "-q");
        assertThat(failed.exitCode()).isEqualTo(ExitCode.BAD_INPUT);
        assertThat(failed.err()).startsWith("twister: ").contains("file not found");
    }

    @Test
    void verboseCommandsTellTheirTime() {
        Outcome made = Outcome.of("scene", "--spheres", "3", "-o", "-", "--verbose");
        assertThat(made.err()).startsWith("twister ").contains(" of processor time");
        assertThat(made.out()).startsWith("{");
    }

    @Test
    void makesASceneUnderATurnedSky() {
        Path file = folder.resolve("scene.json");

        Outcome made = Outcome.of(
                "scene", "--spheres", "2", "--sky-rotation", "-30", "--sky-strength", "0.5", "-o", file.toString());

        assertThat(made.err()).isEmpty();
        Scene scene = SceneReader.read(file);
        assertThat(scene.sky().rotationDegrees()).isEqualTo(-30);
        assertThat(scene.sky().strength()).isEqualTo(0.5);
        assertThat(scene.sky().file()).hasFileName("day.hdr");
    }

    @Test
    void tellsOfMaterialsAndTextures() throws IOException {
        Path texture = folder.resolve("texture.png");
        PngWriter.write(texture, 1, 1, new int[] {0x808080}, true);
        Path file = Files.writeString(folder.resolve("scene.json"), """
                {"version": 2,
                 "camera": {"position": [0, 0, 0], "yaw": 0, "pitch": 0, "fieldOfView": 60},
                 "light": {"position": [0, 9, 0], "radius": 1, "color": [1, 1, 1]},
                 "materials": {
                   "glass": {"color": [1, 1, 1], "reflectivity": 0, "transmission": 1},
                   "stone": {"color": [1, 1, 1], "reflectivity": 0, "texture": "texture.png"}},
                 "plane": {"size": 9, "height": 0, "material": "stone"},
                 "skybox": "texture.png", "spheres": []}
                """);

        assertThat(Outcome.of("scene", "--check", file.toString()).out())
                .contains("valid, 0 spheres, 2 materials, 1 texture");
        assertThat(Outcome.of("render", file.toString(), "--skybox", DAY.toString(), "-o", texture.toString())
                        .err())
                .contains("would replace " + texture);
        Files.writeString(texture, "no picture");
        Outcome broken = Outcome.of("render", file.toString(), "--skybox", DAY.toString(), "-o", file + ".png");
        assertThat(broken.exitCode()).isEqualTo(ExitCode.BAD_INPUT);
        assertThat(broken.err())
                .isEqualToIgnoringNewLines("twister: $.materials.stone.texture: " + texture
                        + ": not a texture by its first bytes; PNG, JPEG and WebP are read");
    }

    @Test
    void tellsOfSpheresThatAreYetToBePoured() {
        assertThat(Outcome.of("scene", "--check", "pour-1000").out())
                .contains("valid, 3 spheres, 1000 more are poured");
    }

    @Test
    void measuresAndReports() {
        Path json = folder.resolve("report.json");
        Path csv = folder.resolve("report.csv");

        Outcome outcome = Outcome.of(
                "benchmark",
                "teaching",
                "--engine",
                "sequential",
                "--engine",
                "parallel",
                "--size",
                "24x16",
                "--classic",
                "--quick",
                "--warmup",
                "1",
                "--frames",
                "2",
                "--json",
                json.toString(),
                "--csv",
                csv.toString());

        assertThat(outcome.err()).isEmpty();
        assertThat(outcome.exitCode()).isZero();
        assertThat(outcome.out())
                .contains("scene teaching, 1 shadow sample, 1 bounce;", "sequential", "parallel", "24x16", "1+2");
        assertThat(json).isNotEmptyFile();
        assertThat(csv).isNotEmptyFile();
    }

    @Test
    void measuresPathsPerSecond() throws IOException {
        Path json = folder.resolve("report.json");
        Path csv = folder.resolve("report.csv");

        Outcome outcome = Outcome.of(
                "benchmark",
                "weekend",
                "--engine",
                "parallel",
                "--size",
                "24x16",
                "--samples",
                "3",
                "--bounces",
                "5",
                "--warmup",
                "0",
                "--frames",
                "2",
                "--json",
                json.toString(),
                "--csv",
                csv.toString());

        assertThat(outcome.err()).isEmpty();
        assertThat(outcome.out())
                .contains("scene weekend, path tracing, 3 samples per pixel, 5 bounces;", "M samples/s");
        JsonNode row = JsonMapper.shared().readTree(json).get("results").get(0);
        assertThat(row.get("integrator").asString()).isEqualTo("path");
        assertThat(row.get("samplesPerPixel").asInt()).isEqualTo(3);
        assertThat(row.get("samplesPerSecond").asDouble())
                .isCloseTo(3 * 24 * 16 * row.get("fps").asDouble(), within(1.0));
        assertThat(csv).content().contains(",integrator,samplesPerPixel,").contains(",path,3,");
    }

    @Test
    void anEngineThatDoesNotWorkHereEndsWithOne() {
        Outcome outcome = Outcome.of(
                "render",
                "benchmark",
                "-o",
                folder.resolve("a.png").toString(),
                "--size",
                "8x8",
                "--engine",
                "tornado");

        assertThat(outcome.exitCode()).isIn(ExitCode.OK, ExitCode.FAILED);
        assertThat(outcome.err()).doesNotContain("\tat ");
    }
}
