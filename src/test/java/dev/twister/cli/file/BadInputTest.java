package dev.twister.cli.file;

import static org.assertj.core.api.Assertions.assertThat;

import dev.twister.Links;
import dev.twister.cli.Outcome;
import dev.twister.image.HdrWriter;
import dev.twister.scene.format.SceneWriter;
import dev.twister.scene.generate.SceneGenerator;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Every faulty command line ends with exit code 2 and one or two lines of text, never with a stack trace. */
class BadInputTest {
    private static final int MOST_LINES = 3;

    @TempDir
    private Path folder;

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            quoteCharacter = '`',
            value = {
                "rendr | Did you mean: twister render",
                "rendr | unknown command 'rendr'",
                "render benchmark mdoel -o FOLDER/a.png | unknown argument 'mdoel'",
                "render benchmark a b -o FOLDER/a.png | unknown arguments 'a', 'b'",
                "render benchmark -o FOLDER/a.png --fast | unknown option '--fast'",
                "render benchmark -o FOLDER/a.png --physics --frames 5-3 | twister: --frames is 5-3, but the last frame comes before the first one",
                "render benchmark -o FOLDER/a.exr --tile 3/2 | twister: --tile is 3, but must be from 1 to 2",
                "join FOLDER -o FOLDER/a.exr | is a folder, but must be a file",
                "film FOLDER/f-#.png -o - | must end in .mp4 or .apng",
                "simulate pour-1000 --frames 2 -o - | --output is -, but this is not written to standard output",
                "benchmark --json - --csv - | --json and --csv are both -",
                "benchmark --jit c2 - | --jit reads the scene several times",
                "benchmark --compare FOLDER/a.json FOLDER/b.json --engine vector | --compare measures nothing",
                "benchmark --compare FOLDER/a.json FOLDER/b.json teaching | --compare measures nothing",
                "benchmark --page FOLDER FOLDER/a.json --engine vector | --page measures nothing",
                "benchmark --page FOLDER FOLDER/a.json | a.json: file not found",
                "benchmark --within 3 | --within requires --compare",
                "benchmark --compare FOLDER/a.json FOLDER/b.json | a.json: file not found",
                "benchmark --compare FOLDER/a.json FOLDER/b.json --within -1 | --within is -1.0, but must be from 0 to 1000",
                "render | SCENE",
                "render benchmark | --output",
                "render benchmark -o FOLDER/a.jpg | must end in .png, .hdr or .exr",
                "render benchmark -o FOLDER/missing/a.png | there is no folder",
                "render benchmark -o FOLDER | must end in",
                "render benchmark -o FOLDER/a.png --overwrite | --overwrite requires --frames",
                "render benchmark -o FOLDER/a%d-#.png --physics --frames 2 | one pattern for the frame number",
                "render benchmrk -o FOLDER/a.png | shipped are: atrium, benchmark",
                "render missing.json -o FOLDER/a.png | missing.json",
                "render FOLDER -o FOLDER/a.png | FOLDER",
                "render benchmark -o FOLDER/a.png --size 0x5 | the size 0x5 has no pixels",
                "render benchmark -o FOLDER/a.png --size 1x16385 | 1x1 to 16384x16384",
                "render benchmark -o FOLDER/a.png --size big | 'big' is not a size",
                "render benchmark -o FOLDER/a.png --engine warp | warp",
                "render pour-1000 -o FOLDER/a.png --physics --start 86400 --engine warp | no engine is called 'warp'",
                "render benchmark -o FOLDER/a.png --shadow-samples 0 | --shadow-samples is 0, but must be from 1 to 1024",
                "render benchmark -o FOLDER/a.png --shadow-samples 1025 | from 1 to 1024",
                "render benchmark -o FOLDER/a.png --shadow-samples 1e3 | --shadow-samples",
                "render benchmark -o FOLDER/a.png --shadow-sampels 3 | --shadow-samples",
                "render benchmark -o FOLDER/a.png --bounces -1 | --bounces is -1, but must be from 0 to 64",
                "render benchmark -o FOLDER/a.png --samples 65537 | --samples is 65537, but must be from 1 to 65536",
                "render benchmark -o FOLDER/a.png --exposure NaN | --exposure is NaN, but must be from -20 to 20",
                "render benchmark -o FOLDER/a.png --exposure Infinity | from -20 to 20",
                "render benchmark -o FOLDER/a.png --exposure bright | 'bright' is not an exposure; write stops, such as 1.5, or auto",
                "render benchmark -o FOLDER/a.png --size 8x8 --exposure auto --sky-strength 0 --camera 0,90,0 --pitch -90 | --exposure is auto, but the picture is black",
                "render benchmark -o FOLDER/a.png --tone-map film | '--tone-map': unknown value 'film'; expected one of: clamp, reinhard, aces",
                "render benchmark -o FOLDER/a.png --camera 1,2 | x,y,z",
                "render benchmark -o FOLDER/a.png --camera 1,NaN,2 | --camera's y is NaN",
                "render benchmark -o FOLDER/a.png --camera-view Front | --camera-view is 'Front', but the scene has no views",
                "render gallery -o FOLDER/a.png --camera-view Front | unknown value 'Front' of --camera-view; expected one of the scene's views: ",
                "render benchmark -o FOLDER/a.png --yaw Infinity | --yaw is Infinity",
                "render benchmark -o FOLDER/a.png --pitch -91 | --pitch is -91.0, but must be from -90 to 90",
                "render benchmark -o FOLDER/a.png --fov 180 | --fov is 180.0, but must be from 1 to 179",
                "render benchmark -o FOLDER/a.png --projection fisheye --fov 361 | --fov is 361.0, but must be from 1 to 360",
                "render benchmark -o FOLDER/a.png --fov 0.5 | --fov is 0.5, but must be from 1 to 179",
                "render benchmark -o FOLDER/a.png --aperture -1 | --aperture is -1.0, but must be from 0 to 1000000",
                "render benchmark -o FOLDER/a.png --focus 0 | --focus is 0.0, but must be from 0.000001 to 1000000",
                "render benchmark -o FOLDER/a.png --skybox FOLDER/none.hdr | none.hdr",
                "gui --engine warp | no engine is called 'warp'",
                "benchmark --engine sequential --engine warp | must be one of sequential",
                "benchmark --jit c3 | unknown value 'c3'; expected one of: c2, graal",
                "benchmark --jit c2 --paper | --jit excludes --paper and --csv",
                "benchmark --jit c2 --csv FOLDER/r.csv | --jit excludes --paper and --csv",
                "benchmark --jit c2 --engine warp | must be one of sequential",
                "devices --json FOLDER/d.json | --engine and --json require --check",
                "devices --check --measure | --check and --measure exclude each other",
                "devices --check --engine warp | must be one of sequential",
                "devices --check --engine sequential --json FOLDER/missing/d.json | --json",
                "benchmark --fps 30 | twister: --fps and --start require --physics",
                "benchmark --frames 0 | --frames is 0, but must be from 1",
                "benchmark --warmup -1 | --warmup is -1, but must be from 0",
                "benchmark --max-seconds NaN | --max-seconds is NaN",
                "benchmark --json FOLDER/missing/r.json | --json",
                "benchmark --csv FOLDER | a file, not a folder",
                "benchmark --json FOLDER/r --csv FOLDER/./r | --json and --csv are both FOLDER",
                "benchmark --json FOLDER/Report.x --csv FOLDER/report.x | --json and --csv are both FOLDER",
                "benchmark none.json --quick | none.json",
                "benchmark --output FOLDER/a | --output is the folder of --paper",
                "benchmark --samples 4 | --samples is for the integrator path, but the picture has whitted; add --integrator path",
                "benchmark --integrator path --classic | --classic is for the integrator whitted",
                "benchmark --integrator path --samples 0 | --samples is 0, but must be from 1 to 65536",
                "benchmark --paper --integrator path --output FOLDER/a | --paper has its own sizes",
                "render benchmark -o FOLDER/a.exr --noise 0.01 --sample-range 0-6 | --sample-range has 7 samples, but --noise needs 8 or more",
                "render benchmark -o FOLDER/a.exr --noise 0.01 --tile 1/2 --view beauty,albedo | --noise with --tile or --sample-range needs one picture; --view has 2",
                "render benchmark -o FOLDER/a.png --noise 0 | --noise is 0.0, but must be from 0.0001 to 1",
                "render benchmark -o FOLDER/a.png --noise 0.01 --samples 4 | --samples with --noise is 4, but must be from 8 to 65536",
                "render benchmark -o FOLDER/a.exr --noise 0.01 --view depth | --noise works for pictures of colors only; use --samples for views of numbers",
                "benchmark --paper --size 640x360 --output FOLDER/a | --paper has its own sizes",
                "benchmark --paper --shadow-samples 3 --output FOLDER/a | --paper has its own sizes, shadow samples",
                "benchmark --paper --bounces 3 --output FOLDER/a | --paper has its own sizes, shadow samples, bounces",
                "benchmark --paper --json FOLDER/a.json --output FOLDER/a | --paper has its own sizes, shadow samples, bounces and files",
                "benchmark --paper --csv FOLDER/a.csv --output FOLDER/a | --paper has its own",
                "benchmark --paper --classic --output FOLDER/a | --paper has its own",
                "benchmark --paper --physics --output FOLDER/a | --paper has its own",
                "benchmark --paper --engine warp --output FOLDER/a | must be one of sequential",
                "benchmark --paper --frames 0 --output FOLDER/a | --frames is 0, but must be from 1",
                "sky -o FOLDER/a.png | must end in .hdr",
                "sky -o FOLDER/a.hdr --elevation 91 | --elevation is 91.0, but must be from 0 to 90",
                "sky -o FOLDER/a.hdr --azimuth NaN | --azimuth",
                "sky -o FOLDER/a.hdr --turbidity 1 | --turbidity is 1.0, but must be from 2 to 10",
                "sky -o FOLDER/a.hdr --size 100x9000 | --size's height is 9000, but must be from 1 to 8192",
                "sky -o FOLDER/a.hdr --preset night | unknown value 'night'; expected one of: day, sunset, overcast",
                "scene | --check",
                "scene --spheres 0 -o FOLDER/a.json | --spheres is 0, but must be from 1",
                "scene --spheres 5 | --output",
                "scene --spheres 5 --skybox FOLDER/none.hdr -o FOLDER/a.json | none.hdr: file not found",
                "scene --check FOLDER/none.json | none.json",
                "scene --check a.json --spheres 5 -o b.json | mutually exclusive"
            })
    void endsWithTwo(String line, String expected) {
        String[] arguments = line.replace("FOLDER", folder.toString()).split(" ");

        Outcome outcome = Outcome.of(arguments);

        assertThat(outcome.err()).contains(expected.replace("FOLDER", folder.toString()));
        assertThat(outcome.err()).doesNotContain("\tat ", "Exception");
        assertThat(outcome.err().lines().count()).isLessThanOrEqualTo(MOST_LINES);
        assertThat(outcome.exitCode()).isEqualTo(ExitCode.BAD_INPUT);
        assertThat(outcome.out()).isEmpty();
        assertThat(folder).isEmptyDirectory();
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "render EMPTY -o FOLDER/a.png",
                "render benchmark -o EMPTY",
                "render benchmark -o FOLDER/a.png --skybox EMPTY",
                "scene --check EMPTY"
            })
    void anEmptyNameIsTold(String line) {
        String[] arguments = Stream.of(line.replace("FOLDER", folder.toString()).split(" "))
                .map(argument -> argument.equals("EMPTY") ? "" : argument)
                .toArray(String[]::new);

        Outcome outcome = Outcome.of(arguments);

        assertThat(outcome.err()).contains("name", "empty").doesNotContain("Exception");
        assertThat(outcome.exitCode()).isEqualTo(ExitCode.BAD_INPUT);
        assertThat(folder).isEmptyDirectory();
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "render|NAME.json|-o|FOLDER/a.png",
                "render|NAME|-o|FOLDER/a.png",
                "render|benchmark|-o|FOLDER/NAME/a.png",
                "render|benchmark|-o|FOLDER/NAME",
                "render|benchmark|-o|FOLDER/a.png|--skybox|NAME.hdr",
                "render|benchmark|-o|FOLDER/a.png|--engine|NAME",
                "render|benchmark|-o|FOLDER/a.png|--size|NAME",
                "render|benchmark|-o|FOLDER/a.png|--NAME",
                "scene|--check|NAME.json",
                "benchmark|NAME.json",
                "NAME"
            })
    void noTextOfTheUsersControlsTheTerminal(String line) {
        String name = "a\u001b[31m\u0007\u009b2J\u202egnp\n\rb";
        String[] arguments =
                line.replace("FOLDER", folder.toString()).replace("NAME", name).split("\\|");

        Outcome outcome = Outcome.of(arguments);

        assertThat(outcome.exitCode()).isEqualTo(ExitCode.BAD_INPUT);
        assertThat(outcome.err()).contains("a\\u001b[31m\\u0007\\u009b2J\\u202egnp\\u000a\\u000db");
        assertThat(outcome.err().lines().count()).isLessThanOrEqualTo(MOST_LINES);
        assertThat(outcome.out()).isEmpty();
    }

    /**
     * On Linux only this character is invalid in a file name; Windows forbids more, and so does a JVM whose file names
     * are ASCII.
     */
    @Test
    void whatNamesNoFileIsTold() {
        Outcome outcome = Outcome.of("render", "benchmark", "-o", "a\0.png");

        assertThat(outcome.exitCode()).isEqualTo(ExitCode.BAD_INPUT);
        assertThat(outcome.err())
                .startsWith("twister: ")
                .contains("--output", "not a valid file name")
                .doesNotContain("Exception")
                .hasLineCount(2);
    }

    @Test
    void aBrokenSceneIsToldWithItsPlace() throws IOException {
        Path scene = Files.writeString(folder.resolve("broken.json"), "{\"version\": 1,\n \"camera\": }");

        Outcome outcome = Outcome.of("scene", "--check", scene.toString());

        assertThat(outcome.exitCode()).isEqualTo(ExitCode.BAD_INPUT);
        assertThat(outcome.err())
                .startsWith("twister: ")
                .contains("broken.json")
                .hasLineCount(1);
    }

    @Test
    void aSkyThatIsNoneIsTold() throws IOException {
        Path sky = Files.writeString(folder.resolve("sky.hdr"), "not a sky");

        Outcome outcome =
                Outcome.of("render", "benchmark", "-o", folder.resolve("a.png").toString(), "--skybox", sky.toString());

        assertThat(outcome.exitCode()).isEqualTo(ExitCode.BAD_INPUT);
        assertThat(outcome.err()).contains("sky.hdr").hasLineCount(1);
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "render benchmark --size 8x8 --skybox FOLDER/a-0000.hdr -o FOLDER/./a-0000.hdr",
                "render benchmark --size 8x8 --skybox FOLDER/a-0000.hdr -o FOLDER/a.hdr --physics --frames 1",
                "render FOLDER/scene.hdr --size 8x8 -o FOLDER/scene.hdr",
                "scene --spheres 3 --skybox FOLDER/a-0000.hdr -o FOLDER/a-0000.hdr",
                "benchmark FOLDER/scene.hdr --json FOLDER/scene.hdr",
                "benchmark FOLDER/scene.hdr --csv FOLDER/a-0000.hdr"
            })
    void whatIsReadIsNotReplaced(String line) throws IOException {
        Path sky = folder.resolve("a-0000.hdr");
        HdrWriter.write(sky, 2, 1, new float[6]);
        Path scene = folder.resolve("scene.hdr");
        SceneWriter.write(SceneGenerator.spheres(1, 1, sky), scene);
        byte[] skyBefore = Files.readAllBytes(sky);
        byte[] sceneBefore = Files.readAllBytes(scene);

        Outcome outcome = Outcome.of(line.replace("FOLDER", folder.toString()).split(" "));

        assertThat(outcome.err())
                .contains("would replace " + folder, "give another file")
                .hasLineCount(1);
        assertThat(outcome.exitCode()).isEqualTo(ExitCode.BAD_INPUT);
        assertThat(sky).hasBinaryContent(skyBefore);
        assertThat(scene).hasBinaryContent(sceneBefore);
    }

    @Test
    void aLinkIntoAFolderThatIsNotThereIsToldBeforeTheWork() {
        Path missing = folder.resolve("missing");
        Path link = Links.make(folder.resolve("a.png"), missing.resolve("a.png"));

        Outcome outcome = Outcome.of("render", "none.json", "-o", link.toString());

        assertThat(outcome.exitCode()).isEqualTo(ExitCode.BAD_INPUT);
        assertThat(outcome.err())
                .contains("--output is " + link + ", but there is no folder " + missing)
                .hasLineCount(1);
    }

    @Test
    void linksThatLeadToOneAnotherAreToldBeforeTheWork() {
        Path link = Links.make(folder.resolve("a.png"), folder.resolve("b.png"));
        Links.make(folder.resolve("b.png"), link);

        Outcome outcome = Outcome.of("render", "none.json", "-o", link.toString());

        assertThat(outcome.exitCode()).isEqualTo(ExitCode.BAD_INPUT);
        assertThat(outcome.err())
                .contains("--output is " + link + ", but its links lead to one another")
                .hasLineCount(1);
    }
}
