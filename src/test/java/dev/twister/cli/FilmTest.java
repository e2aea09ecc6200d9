package dev.twister.cli;

import static org.assertj.core.api.Assertions.assertThat;

import dev.twister.image.PngNotes;
import java.io.File;
import java.io.IOException;
import java.io.RandomAccessFile;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.FileTime;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Renders a film, from the simulation to the file. */
class FilmTest {
    private static final String SCENE = "pour-1000";

    @TempDir
    private Path folder;

    private String size = "32x18";

    @Test
    void simulatingGoesOnAfterAKill() throws IOException {
        Path motion = simulate("0-11");
        byte[] whole = Files.readAllBytes(motion);
        try (RandomAccessFile file = new RandomAccessFile(motion.toFile(), "rw")) {
            file.setLength(whole.length / 2);
        }

        Outcome outcome = Outcome.of("simulate", SCENE, "-o", motion.toString(), "--frames", "12", "--fps", "10");

        assertThat(outcome.err()).isEmpty();
        assertThat(outcome.out()).contains("5 kept");
        assertThat(motion).hasBinaryContent(whole);
    }

    @Test
    void simulatingTellsHowFarItIsAndExportsPoints() {
        Path motion = folder.resolve("shot.motion");

        Outcome outcome = Outcome.of(
                "simulate", SCENE, "-o", motion.toString(), "--frames", "3", "--progress", "lines", "--export", "pc2");

        assertThat(outcome.err()).isEmpty();
        assertThat(outcome.out())
                .contains("openjd_progress: 100.0", "openjd_status: simulating: 3 of 3, 0 s left")
                .contains(folder.resolve("shot.pc2") + ": a point cache of 3 frames");
        assertThat(folder.resolve("shot.pc2")).isNotEmptyFile();
    }

    @Test
    void framesOfAMotionFileAreThoseOfOneRun() throws IOException {
        Path motion = simulate("0-11");

        render("a-####.png", "--motion", motion.toString(), "--frames", "9-11");
        render("b.png", "--physics", "--fps", "10", "--frames", "10-11");
        render("c.png", "--physics", "--fps", "10", "--frames", "12");

        for (String number : new String[] {"0010", "0011"}) {
            byte[] frame = Files.readAllBytes(folder.resolve("a-" + number + ".png"));
            assertThat(folder.resolve("b-" + number + ".png")).hasBinaryContent(frame);
            assertThat(folder.resolve("c-" + number + ".png")).hasBinaryContent(frame);
        }
        assertThat(folder.resolve("a-0009.png")).exists();
        assertThat(folder.resolve("b-0009.png")).doesNotExist();
    }

    @Test
    void skipsFramesThatAreWholeAndTheSame() throws IOException {
        String[] film = {"--turntable", "1", "--fps", "4", "--skip-existing"};
        render("f-####.png", film);
        List<byte[]> frames = new ArrayList<>();
        for (int number = 0; number < 4; number++) {
            frames.add(Files.readAllBytes(frame(number)));
            Files.setLastModifiedTime(frame(number), FileTime.fromMillis(0));
        }
        Files.delete(frame(1));
        try (RandomAccessFile cut = new RandomAccessFile(frame(2).toFile(), "rw")) {
            cut.setLength(cut.length() - 1);
        }

        Outcome outcome = render("f-####.png", film);

        assertThat(outcome.out()).contains("4 frames").contains("2 kept");
        for (int number = 0; number < 4; number++) {
            assertThat(frame(number)).hasBinaryContent(frames.get(number));
        }
        assertThat(Files.getLastModifiedTime(frame(0)).toMillis()).isZero();
        assertThat(Files.getLastModifiedTime(frame(1)).toMillis()).isPositive();
        assertThat(Files.getLastModifiedTime(frame(2)).toMillis()).isPositive();
        assertThat(Files.getLastModifiedTime(frame(3)).toMillis()).isZero();

        String[] brighter = {"--turntable", "1", "--fps", "4", "--skip-existing", "--exposure", "1"};
        assertThat(render("f-####.png", brighter).out()).doesNotContain("kept");
        assertThat(Files.readAllBytes(frame(0))).isNotEqualTo(frames.getFirst());
    }

    @Test
    void anExposureOfAutoIsTheSameInAllPartsOfAFilm() throws IOException {
        render("whole-####.png", "--turntable", "1", "--fps", "4", "--exposure", "auto");
        render("part-####.png", "--turntable", "1", "--fps", "4", "--frames", "2-3", "--exposure", "auto");
        render("plain-####.png", "--turntable", "1", "--fps", "4", "--frames", "2-3");

        byte[] whole = Files.readAllBytes(folder.resolve("whole-0002.png"));
        assertThat(folder.resolve("part-0002.png")).hasBinaryContent(whole);
        assertThat(Files.readAllBytes(folder.resolve("plain-0002.png"))).isNotEqualTo(whole);
    }

    @Test
    void otherKindsOfFilesAreSkippedToo() {
        for (String name : new String[] {"f.exr", "f.hdr"}) {
            String[] film = {"--turntable", "1", "--fps", "2", "--skip-existing"};
            render(name, film);

            assertThat(render(name, film).out()).contains("2 kept");
        }
    }

    @ParameterizedTest
    @ValueSource(strings = {".png", ".hdr", ".exr"})
    void aDamagedFrameIsRenderedAgainWithALine(String ending) throws IOException {
        String[] film = {"--turntable", "1", "--fps", "2", "--skip-existing"};
        render("f" + ending, film);
        Path file = folder.resolve("f-0001" + ending);
        byte[] whole = Files.readAllBytes(file);
        List<byte[]> damages =
                List.of(Arrays.copyOf(whole, whole.length - 1), Arrays.copyOf(whole, 20), new byte[0], changed(whole));
        for (byte[] damaged : damages) {
            Files.write(file, damaged);

            Outcome outcome = render("f" + ending, film);

            assertThat(outcome.err())
                    .isEqualToIgnoringNewLines("twister: " + file + " is damaged or incomplete; rendering it again");
            assertThat(outcome.out()).contains("1 kept");
            assertThat(file).hasBinaryContent(whole);
        }
    }

    /** With another byte in the compressed pixels, or for .hdr, another resolution. */
    private static byte[] changed(byte[] file) {
        String text = new String(file, StandardCharsets.ISO_8859_1);
        byte[] changed = file.clone();
        int place = text.startsWith("#?RADIANCE") ? text.indexOf("\n-Y ") + 1 : file.length / 2;
        changed[place] ^= 0x10;
        return changed;
    }

    @ParameterizedTest
    @ValueSource(strings = {".png", ".hdr", ".exr"})
    void aFrameOfAnotherSizeIsRenderedAgainWithALine(String ending) {
        String[] film = {"--turntable", "1", "--fps", "2", "--frames", "0-0", "--skip-existing"};
        size = "40x30";
        render("f" + ending, film);
        size = "32x18";

        Outcome outcome = render("f" + ending, film);

        assertThat(outcome.err())
                .isEqualToIgnoringNewLines("twister: " + folder.resolve("f-0000" + ending)
                        + " differs in its scene, settings or version; rendering it again");
        assertThat(render("f" + ending, film).err()).isEmpty();
    }

    @Test
    void twoWorkersMayWriteIntoOneFolderAtOnce() throws IOException, ExecutionException, InterruptedException {
        try (ExecutorService workers = Executors.newFixedThreadPool(2)) {
            String[] film = {"--turntable", "1", "--fps", "6", "--skip-existing"};
            Future<Outcome> one = workers.submit(() -> render("f-####.png", film));
            Future<Outcome> other = workers.submit(() -> render("f-####.png", film));

            assertThat(one.get().exitCode()).isZero();
            assertThat(other.get().exitCode()).isZero();
        }

        assertThat(folder.toFile().list()).hasSize(6).allMatch(name -> name.matches("f-000\\d\\.png"));
        for (int number = 0; number < 6; number++) {
            assertThat(PngNotes.of(frame(number)).provenance()).isPresent();
        }
    }

    @Test
    void filmsAreMadeOfFramesAndInOneGo() throws IOException {
        render("f-####.png", "--turntable", "1", "--fps", "3");
        Path film = folder.resolve("film.apng");
        Path direct = folder.resolve("direct.apng");

        Outcome outcome =
                Outcome.of("film", folder.resolve("f-####.png").toString(), "-o", film.toString(), "--fps", "3");
        render("direct.apng", "--turntable", "1", "--fps", "3");

        assertThat(outcome.err()).isEmpty();
        assertThat(outcome.out()).startsWith(film + ": 3 frames of 32 x 18, animated PNG");
        assertThat(direct).hasSameBinaryContentAs(film);

        Files.delete(frame(1));
        assertThat(Outcome.of("film", folder.resolve("f-####.png").toString(), "-o", film.toString())
                        .err())
                .startsWith("twister: the film lacks frames 1;");
    }

    @Test
    void aFilmThatFailsLeavesNoFile() throws IOException {
        render("f-####.png", "--turntable", "1", "--fps", "3");
        Files.writeString(frame(2), "no picture");

        Outcome outcome = Outcome.of(
                "film",
                folder.resolve("f-####.png").toString(),
                "-o",
                folder.resolve("film.apng").toString());

        assertThat(outcome.exitCode()).isEqualTo(2);
        assertThat(outcome.err()).hasLineCount(1).contains("f-0002.png");
        assertThat(folder.toFile().list()).hasSize(3);
    }

    @Test
    void keyframesMoveTheCameraThroughTheFilm() throws IOException {
        Path scene = Files.writeString(
                folder.resolve("moving.json"),
                Files.readString(Path.of("scenes", "benchmark.json"))
                        .replace("\"version\": 1", "\"version\": 2")
                        .replace(
                                "\"fieldOfView\": 50",
                                "\"fieldOfView\": 50, \"keyframes\": ["
                                        + "{\"time\": 0, \"position\": [0, -5, -15], \"yaw\": 0, \"pitch\": 7},"
                                        + "{\"time\": 1, \"position\": [4, -5, -15], \"yaw\": -20, \"pitch\": 7}]")
                        .replace(
                                "../skyboxes",
                                new File("skyboxes").getAbsolutePath().replace('\\', '/')));

        Outcome outcome = renderScene(scene.toString(), "k-####.png", "--fps", "2", "--frames", "1-2");
        renderScene("benchmark", "still.png", "--camera", "4,-5,-15", "--yaw", "-20", "--pitch", "7", "--fov", "50");

        assertThat(outcome.err()).isEmpty();
        assertThat(folder.resolve("k-0002.png")).hasSameBinaryContentAs(folder.resolve("still.png"));
        assertThat(Files.readAllBytes(folder.resolve("k-0001.png")))
                .isNotEqualTo(Files.readAllBytes(folder.resolve("k-0002.png")));
    }

    @Test
    void aPictureAtATimeIsTheFrameOfThatTime() throws IOException {
        renderScene("juggling", "t-####.png", "--fps", "2", "--frames", "0-1");
        Outcome outcome = renderScene("juggling", "at.png", "--time", "0.5");

        assertThat(outcome.err()).isEmpty();
        assertThat(folder.resolve("at.png")).hasSameBinaryContentAs(folder.resolve("t-0001.png"));
        assertThat(Files.readAllBytes(folder.resolve("t-0000.png")))
                .isNotEqualTo(Files.readAllBytes(folder.resolve("at.png")));
    }

    @Test
    void optionsReplaceTracks() throws IOException {
        Path scene = Files.writeString(
                folder.resolve("dim.json"),
                Files.readString(Path.of("scenes", "teaching.json"))
                        .replace("\"version\": 1", "\"version\": 3")
                        .replace(
                                "  \"spheres\"",
                                "  \"tracks\": [{\"target\": \"rendering\", \"property\": \"exposure\","
                                        + " \"keyframes\": [{\"time\": 0, \"value\": -20}]},"
                                        + "{\"target\": \"sky\", \"property\": \"strength\","
                                        + " \"keyframes\": [{\"time\": 0, \"value\": 1}]}],\n  \"spheres\"")
                        .replace(
                                "../skyboxes",
                                new File("skyboxes").getAbsolutePath().replace('\\', '/')));

        renderScene(scene.toString(), "own.png", "--exposure", "1", "--frames", "0-0");
        renderScene("teaching", "still.png", "--exposure", "1");

        assertThat(folder.resolve("own-0000.png")).hasSameBinaryContentAs(folder.resolve("still.png"));
    }

    @Test
    void numberedFramesOfKeyframesAreTheWholeFilm() {
        assertThat(renderScene("juggling", "n-####.png", "--fps", "1").out()).contains("5 frames");
        assertThat(renderScene("juggling", "n-####.png", "--fps", "1", "--skip-existing")
                        .out())
                .contains("5 frames", "5 kept");
        assertThat(renderScene("juggling", "rate.png", "--fps", "0.5").out()).contains("3 frames");
        assertThat(renderScene("juggling", "still.png").out()).contains("still.png: 32 x 18");

        assertThat(folder.toFile().list()).hasSize(9).contains("n-0004.png", "rate-0002.png", "still.png");
    }

    @Test
    void namesOfNumberedFramesAreNoNamesOfPictures() {
        String output = folder.resolve("x-####.png").toString();

        assertThat(List.of(
                        Outcome.of("render", "teaching", "-o", output),
                        Outcome.of("render", "juggling", "-o", output, "--time", "1"),
                        Outcome.of("render", "pour-1000", "-o", output, "--physics")))
                .allSatisfy(outcome -> {
                    assertThat(outcome.exitCode()).isEqualTo(2);
                    assertThat(outcome.err()).contains(output + ", a name of numbered frames").hasLineCount(1);
                });
        assertThat(folder).isEmptyDirectory();
    }

    @Test
    void aTimeNeedsKeyframes() {
        Path file = folder.resolve("x.png");

        assertThat(Outcome.of("render", "teaching", "-o", file.toString(), "--time", "1")
                        .err())
                .startsWith("twister: --time requires a scene with keyframes");
    }

    private Path frame(int number) {
        return folder.resolve("f-000" + number + ".png");
    }

    private Path simulate(String frames) {
        Path motion = folder.resolve("shot.motion");
        Outcome outcome = Outcome.of("simulate", SCENE, "-o", motion.toString(), "--frames", frames, "--fps", "10");
        assertThat(outcome.err()).isEmpty();
        return motion;
    }

    private Outcome render(String name, String... options) {
        return renderScene(options[0].equals("--turntable") ? "benchmark" : SCENE, name, options);
    }

    private Outcome renderScene(String scene, String name, String... options) {
        List<String> arguments = new ArrayList<>(List.of(
                "render",
                scene,
                "-o",
                folder.resolve(name).toString(),
                "--size",
                size,
                "--engine",
                "sequential",
                "--shadow-samples",
                "1"));
        arguments.addAll(List.of(options));
        Outcome outcome = Outcome.of(arguments.toArray(String[]::new));
        assertThat(outcome.err().lines()).allMatch(line -> line.endsWith("; rendering it again"));
        return outcome;
    }
}
