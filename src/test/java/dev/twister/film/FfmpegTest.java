package dev.twister.film;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIOException;

import java.io.File;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;

@DisabledOnOs(OS.WINDOWS)
class FfmpegTest {
    private static final FilmFormat FORMAT = new FilmFormat(2, 1, 60, 2);

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
    void isGivenTheFramesBytesAndWritesTheFilm() throws IOException {
        Ffmpeg ffmpeg = program("for last; do :; done; cat >\"$last\"");
        Path film = folder.resolve("film.mp4");

        ffmpeg.write(film, FORMAT, () -> new int[] {0xff010203, 0xff040506});

        byte[] frame = {3, 2, 1, -1, 6, 5, 4, -1};
        assertThat(Files.readAllBytes(film)).startsWith(frame).endsWith(frame).hasSize(16);
    }

    @Test
    void tellsWhatFfmpegSaidLast() throws IOException {
        Ffmpeg ffmpeg = program("echo 'Unknown encoder' >&2; exit 1");

        assertThatIOException()
                .isThrownBy(() -> ffmpeg.write(folder.resolve("film.mp4"), FORMAT, () -> new int[2]))
                .withMessage(ffmpeg.program() + " failed: Unknown encoder");
        assertThat(folder.resolve("film.mp4")).doesNotExist();
    }

    @Test
    void anEncoderThatClosesItsInputBeforeItEndsIsAskedWhy() throws IOException {
        Ffmpeg ffmpeg =
                program("exec <&-; touch \"$(dirname \"$0\")/closed\"; sleep 0.3; echo 'Unknown encoder' >&2; exit 1");

        assertThatIOException()
                .isThrownBy(() -> ffmpeg.write(folder.resolve("film.mp4"), FORMAT, () -> {
                    awaitClosedInput();
                    return new int[2];
                }))
                .withMessage(ffmpeg.program() + " failed: Unknown encoder");
    }

    @Test
    void whatTheSourceThrowsIsThrownAndNoFilmIsLeft() throws IOException {
        Ffmpeg ffmpeg = program("cat >/dev/null");

        assertThatIOException()
                .isThrownBy(() -> ffmpeg.write(folder.resolve("film.mp4"), FORMAT, () -> {
                    throw new IOException("no frame");
                }))
                .withMessage("no frame");
        assertThat(folder.resolve("film.mp4")).doesNotExist();
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
