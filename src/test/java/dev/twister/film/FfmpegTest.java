package dev.twister.film;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIOException;
import static org.assertj.core.api.Assumptions.assumeThat;

import dev.twister.ChildJvm;
import dev.twister.image.PngWriter;
import dev.twister.image.Provenance;
import java.io.File;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.locks.LockSupport;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;

@DisabledOnOs(OS.WINDOWS)
class FfmpegTest {
    private static final FilmFormat FORMAT = new FilmFormat(2, 2, 60, 2, false);
    private static final int[] FRAME = {0xff010203, 0xff040506, 0xff070809, 0xff0a0b0c};

    @TempDir
    private Path folder;

    @Test
    void isFoundOnThePath() throws IOException {
        Ffmpeg ffmpeg = program("");

        assertThat(Ffmpeg.find("/nowhere" + File.pathSeparator + folder)).contains(ffmpeg);
        assertThat(Ffmpeg.find("/nowhere")).isEmpty();
        assertThat(Ffmpeg.find("")).isEmpty();
    }

    @Test
    void entriesThatAreNoPathsArePassedOver() throws IOException {
        Ffmpeg ffmpeg = program("");

        assertThat(Ffmpeg.find("\0" + File.pathSeparator + folder)).contains(ffmpeg);
    }

    @Test
    void framesOfOnePixelAreRefusedBeforeFfmpegStarts() throws IOException {
        Ffmpeg ffmpeg = program("");

        assertThatIOException()
                .isThrownBy(() -> ffmpeg.begin(folder.resolve("small.mp4"), new FilmFormat(1, 1, 60, 2, false)))
                .withMessageContaining("frames of 1 x 1 pixels are too small for H.264");
        assertThat(folder.toFile().list()).containsExactly("ffmpeg");
    }

    /** Other programs must play it, at the rate of the frames. */
    @Test
    void theDocumentedPipeMakesAFilmThatPlayersTake() throws IOException, InterruptedException {
        Path program = Ffmpeg.find(System.getenv("PATH")).map(Ffmpeg::program).orElse(Path.of("ffmpeg"));
        assumeThat(program).isExecutable();
        String command = Files.readString(Path.of("docs", "commands.md"))
                .lines()
                .filter(line -> line.contains("| ffmpeg "))
                .findFirst()
                .orElseThrow();
        List<String> words = new ArrayList<>(
                List.of(command.substring(command.indexOf("| ffmpeg ") + 2).split(" ")));
        words.set(0, program.toString());
        Process ffmpeg = new ProcessBuilder(words)
                .directory(folder.toFile())
                .redirectOutput(ProcessBuilder.Redirect.DISCARD)
                .redirectError(ProcessBuilder.Redirect.DISCARD)
                .start();
        try (OutputStream out = ffmpeg.getOutputStream()) {
            for (int frame = 0; frame < 3; frame++) {
                int[] argb = new int[32 * 18];
                Arrays.fill(argb, 0xff000000 | 0x50 * frame);
                PngWriter.write(out, 32, 18, argb, true, false, new Provenance("", "", ""));
            }
        }
        assertThat(ffmpeg.waitFor()).isZero();

        Process probe = new ProcessBuilder(
                        program.resolveSibling("ffprobe").toString(),
                        "-v",
                        "error",
                        "-count_frames",
                        "-show_entries",
                        "stream=pix_fmt,r_frame_rate,nb_read_frames",
                        "-of",
                        "default=nw=1",
                        words.getLast())
                .directory(folder.toFile())
                .start();
        assertThat(probe.inputReader().lines())
                .containsExactlyInAnyOrder("pix_fmt=yuv420p", "r_frame_rate=60/1", "nb_read_frames=3");
    }

    @Test
    void isGivenTheFramesBytesAndWritesTheFilm() throws IOException {
        Files.write(folder.resolve("good.mp4"), Mp4Boxes.film(FORMAT.frames(), 60));
        Ffmpeg ffmpeg = program("cd \"$(dirname \"$0\")\"; for last; do :; done; cat >frames; cat good.mp4 >\"$last\"");
        Path film = folder.resolve("film.mp4");

        write(ffmpeg, film);

        assertThat(film).hasSameBinaryContentAs(folder.resolve("good.mp4"));
        assertThat(folder.resolve("frames")).hasBinaryContent(new byte[] {
            3, 2, 1, -1, 6, 5, 4, -1, 9, 8, 7, -1, 12, 11, 10, -1,
            3, 2, 1, -1, 6, 5, 4, -1, 9, 8, 7, -1, 12, 11, 10, -1
        });
    }

    @Test
    void aFilmThatIsNotWholeIsRefusedWhateverTheExitCodeAndTheEarlierOneStays() throws IOException {
        Files.write(folder.resolve("short.mp4"), Mp4Boxes.film(FORMAT.frames() - 1, 60));
        Ffmpeg ffmpeg =
                program("cd \"$(dirname \"$0\")\"; for last; do :; done; cat >/dev/null; cat short.mp4 >\"$last\";"
                        + " echo \"Error writing trailer of $last: No space left on device\"");
        Path film = Files.writeString(folder.resolve("film.mp4"), "earlier");

        assertThatIOException()
                .isThrownBy(() -> write(ffmpeg, film))
                .withMessage("cannot write " + film + ": " + ffmpeg.program()
                        + " left an incomplete film: it has 1 of 2 frames: Error writing trailer of " + film
                        + ": No space left on device");
        assertThat(film).hasContent("earlier");
        assertThat(folder.toFile().list()).containsExactlyInAnyOrder("film.mp4", "short.mp4", "ffmpeg");
    }

    @Test
    void tellsWhatFfmpegSaidLast() throws IOException {
        Ffmpeg ffmpeg = program("echo 'Unknown encoder' >&2; exit 1");

        assertThatIOException()
                .isThrownBy(() -> write(ffmpeg, folder.resolve("film.mp4")))
                .withMessage(failed(ffmpeg, "exit code 1: Unknown encoder"));
        assertThat(folder.toFile().list()).containsExactly("ffmpeg");
    }

    @Test
    void tellsWhatFfmpegSaidBeforeItWasKilled() throws IOException {
        Ffmpeg ffmpeg = program("echo 'almost there' >&2; kill -9 $$");

        assertThatIOException()
                .isThrownBy(() -> write(ffmpeg, folder.resolve("film.mp4")))
                .withMessage(failed(ffmpeg, "exit code 137: almost there"));
    }

    @Test
    void anEncoderThatClosesItsInputBeforeItEndsIsAskedWhy() throws IOException {
        Ffmpeg ffmpeg =
                program("exec <&-; touch \"$(dirname \"$0\")/closed\"; sleep 0.3; echo 'Unknown encoder' >&2; exit 1");

        try (FilmEncoder film = ffmpeg.begin(folder.resolve("film.mp4"), FORMAT)) {
            awaitClosedInput();

            assertThatIOException()
                    .isThrownBy(() -> film.add(FRAME))
                    .withMessage(failed(ffmpeg, "exit code 1: Unknown encoder"));
        }
    }

    @Test
    void aFilmThatIsGivenUpLeavesNoFile() throws IOException {
        Ffmpeg ffmpeg = program("cat >/dev/null");
        Path film = folder.resolve("film.mp4");

        try (FilmEncoder begun = ffmpeg.begin(film, FORMAT)) {
            begun.add(FRAME);
        }
        assertThat(folder.toFile().list()).containsExactly("ffmpeg");
    }

    @Test
    void anEncoderThatCreatesItsFileLateLeavesNoneWhenTheProcessIsTerminated()
            throws IOException, InterruptedException {
        Ffmpeg ffmpeg = program("for last; do :; done; cat >/dev/null; echo late >\"$last\"");
        Path films = Files.createDirectory(folder.resolve("films"));
        Process java = ChildJvm.start(ChildJvm.of(
                        FilmMain.class,
                        ffmpeg.program().toString(),
                        films.resolve("film.mp4").toString())
                .redirectError(ProcessBuilder.Redirect.INHERIT));
        assertThat(java.inputReader().readLine()).isEqualTo("begun");

        java.destroy();
        java.waitFor();

        assertThat(films).isEmptyDirectory();
    }

    /** Begins a film that it never finishes. */
    static final class FilmMain {
        private FilmMain() {}

        public static void main(String[] arguments) throws IOException {
            try (FilmEncoder film = new Ffmpeg(Path.of(arguments[0])).begin(Path.of(arguments[1]), FORMAT)) {
                film.add(FRAME);
                System.out.println("begun");
                while (true) {
                    LockSupport.park();
                }
            }
        }
    }

    private String failed(Ffmpeg ffmpeg, String how) {
        return "cannot write " + folder.resolve("film.mp4") + ": " + ffmpeg.program() + " ended with " + how;
    }

    private static void write(Ffmpeg ffmpeg, Path file) throws IOException {
        try (FilmEncoder film = ffmpeg.begin(file, FORMAT)) {
            film.add(FRAME);
            film.add(FRAME);
            film.finish();
        }
    }

    private void awaitClosedInput() {
        while (!Files.exists(folder.resolve("closed"))) {
            Thread.onSpinWait();
        }
    }

    private Ffmpeg program(String body) throws IOException {
        Path file = Files.writeString(folder.resolve("ffmpeg"), "#!/bin/sh\n" + body + "\n");
        assertThat(file.toFile().setExecutable(true)).isTrue();
        return new Ffmpeg(file);
    }
}
