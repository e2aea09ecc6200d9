package dev.twister.cli.command;

import static org.assertj.core.api.Assertions.assertThat;

import dev.twister.cli.Outcome;
import dev.twister.cli.file.ExitCode;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/** Traces one pixel's path from the command line. */
class ExplainCommandTest {
    @Test
    void theExamplesOfItsHelpWork() {
        List<String> examples = Outcome.of("explain", "--help")
                .out()
                .lines()
                .map(String::strip)
                .filter(line -> line.startsWith("twister explain "))
                .toList();

        assertThat(examples).hasSizeGreaterThan(2).allSatisfy(example -> {
            Outcome outcome = Outcome.of(example.substring("twister ".length()).split(" "));
            assertThat(outcome.err()).isEmpty();
            assertThat(outcome.exitCode()).isZero();
        });
    }

    @Test
    void tableHasAStepPerRay() {
        Outcome outcome = explain("--pixel", "108,52");

        assertThat(outcome.exitCode()).isEqualTo(ExitCode.OK);
        assertThat(outcome.out().lines())
                .anyMatch(line -> line.startsWith("0 ") && line.contains("view") && line.contains("body 4"))
                .anyMatch(line -> line.startsWith("1 ") && line.contains("reflected") && line.contains("plane"))
                .anyMatch(line -> line.startsWith("2 ") && line.contains("sky"))
                .anyMatch(line -> line.startsWith("step 0: point (") && line.endsWith("64 shadow rays, 64 free"));
        assertThat(outcome.out()).doesNotContain("\r").endsWith("\n");
    }

    @Test
    void bodiesHaveTheirNamesInTheSceneFile(@TempDir Path folder) throws IOException {
        Path scene = folder.resolve("named.json");
        Files.writeString(scene, """
                {"version": 3, "skybox": "%s",
                 "camera": {"position": [0, 0, -5], "yaw": 0, "pitch": 0, "fieldOfView": 45},
                 "light": {"position": [0, 9, -9], "radius": 1, "color": [1, 1, 1]},
                 "plane": {"size": 1, "height": -5, "colors": [[1, 1, 1], [0, 0, 0]], "reflectivity": 0},
                 "materials": {"gold": {"color": [1, 0.8, 0.3], "reflectivity": 128}},
                 "spheres": [
                   {"position": [0, 0, 0], "radius": 1, "color": [1, 1, 1], "reflectivity": 0, "hidden": true},
                   {"position": [0, 0, 0], "radius": 1, "material": "gold", "name": "Ball"}]}
                """.formatted(Path.of("skyboxes", "day.hdr").toAbsolutePath()));
        Outcome text = Outcome.of("explain", scene.toString(), "--size", "32x32", "--pixel", "16,16");
        Outcome json = Outcome.of("explain", scene.toString(), "--size", "32x32", "--pixel", "16,16", "--json");

        assertThat(text.out()).contains("body 2: sphere 2, \"Ball\", material \"gold\"\n");
        assertThat(JsonMapper.shared().readTree(json.out()).at("/steps/0/meets"))
                .isEqualTo(JsonMapper.shared().readTree("""
                        {"kind": "sphere", "number": 2, "name": "Ball", "material": "gold"}"""));
    }

    @Test
    void partsOfMeshesHaveTheirFile() {
        Outcome outcome = Outcome.of("explain", "knot", "--size", "64x36", "--pixel", "25,18", "--bounces", "0");

        assertThat(outcome.out()).contains("body 5: mesh 1, meshes/knot.obj, part glass\n");
    }

    @Test
    void jsonAddsUp() {
        JsonNode tree = JsonMapper.shared()
                .readTree(explain("--pixel", "108,52", "--shadow-samples", "3", "--json")
                        .out());

        float sum = 0;
        for (JsonNode step : tree.get("steps")) {
            sum += step.get("adds").get(0).floatValue();
        }
        assertThat(tree.get("pixelRadiance").get(0).floatValue()).isEqualTo(sum);
        assertThat(tree.get("steps").get(0).get("surface").get("shadowRays").size())
                .isEqualTo(3);
        assertThat(tree.get("steps").get(2).has("surface")).isFalse();
    }

    @Test
    void aTracedPathHasItsProbabilities() {
        Outcome outcome = Outcome.of(
                "explain", "weekend", "--size", "160x90", "--pixel", "80,52", "--samples", "4", "--sample", "3");

        assertThat(outcome.exitCode()).isEqualTo(ExitCode.OK);
        assertThat(outcome.err()).isEmpty();
        assertThat(outcome.out())
                .startsWith("Pixel 80,52, sample 3 of 4, path tracing\n")
                .contains("p surface", "p light", "lobes: mirror", "chose emitter sky with probability 1.0000")
                .contains("Sum of the steps: ");
    }

    @Test
    void jsonOfATracedPathAddsUp() {
        JsonNode tree = JsonMapper.shared()
                .readTree(explain("--integrator", "path", "--pixel", "108,52", "--json")
                        .out());

        float sum = 0;
        for (JsonNode step : tree.get("steps")) {
            sum += step.get("adds").get(0).floatValue();
        }
        assertThat(tree.get("pixelRadiance").get(0).floatValue()).isEqualTo(sum);
        assertThat(tree.get("steps")
                        .get(0)
                        .get("scattering")
                        .get("next")
                        .get("probability")
                        .asDouble())
                .isPositive();
    }

    @Test
    void theExampleWithASampleWorks() {
        Outcome outcome =
                Outcome.of("explain", "glass", "--pixel", "640,400", "--samples", "8", "--sample", "3", "--json");

        assertThat(outcome.exitCode()).isEqualTo(ExitCode.OK);
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "160,0 | 0 | --pixel's column is 160, but must be from 0 to 159",
                "0,-1 | 0 | --pixel's row is -1, but must be from 0 to 89",
                "0,0 | 1 | --sample is 1, but must be from 0 to 0"
            })
    void pixelsAndSamplesThatAreNotThereAreRefused(String pixel, String sample, String message) {
        Outcome outcome = explain("--pixel", pixel, "--sample", sample);

        assertThat(outcome.exitCode()).isEqualTo(ExitCode.BAD_INPUT);
        assertThat(outcome.err()).isEqualToIgnoringNewLines("twister: " + message);
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {"1", "1,2,3", "a,b"})
    void whatIsNoPixelIsRefused(String pixel) {
        Outcome outcome = explain("--pixel", pixel);

        assertThat(outcome.exitCode()).isEqualTo(ExitCode.BAD_INPUT);
        assertThat(outcome.err()).contains("'" + pixel + "' is not a pixel; write column,row");
    }

    private static Outcome explain(String... options) {
        String[] arguments = new String[options.length + 4];
        System.arraycopy(new String[] {"explain", "teaching", "--size", "160x90"}, 0, arguments, 0, 4);
        System.arraycopy(options, 0, arguments, 4, options.length);
        return Outcome.of(arguments);
    }
}
