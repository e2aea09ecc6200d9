package dev.twister.film;

import static org.assertj.core.api.Assertions.assertThatCode;
import static org.assertj.core.api.Assertions.assertThatIOException;

import java.io.IOException;
import java.nio.channels.FileChannel;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class Mp4FileTest {
    private static final FilmFormat FORMAT = new FilmFormat(16, 16, 60, 30, false);

    @TempDir
    private Path folder;

    @Test
    void aWholeFilmPasses() {
        assertThatCode(() -> check(Mp4Boxes.film(30, 60))).doesNotThrowAnyException();
    }

    @Test
    void aFilmCutAnywhereIsRefused() {
        byte[] whole = Mp4Boxes.film(30, 60);
        for (int length = 0; length < whole.length; length++) {
            byte[] cut = Arrays.copyOf(whole, length);
            assertThatIOException().as("cut to %d bytes", length).isThrownBy(() -> check(cut));
        }
    }

    @Test
    void aFilmWithoutIndexIsRefused() {
        assertRefused(Mp4Boxes.box("mdat", new byte[300]), "it has no index");
    }

    @Test
    void aFilmThatLacksAFrameIsRefused() {
        assertRefused(Mp4Boxes.film(29, 60), "it has 29 of 30 frames");
    }

    @Test
    void aFilmOfAnotherDurationIsRefused() {
        assertRefused(Mp4Boxes.film(30, 30), "it is 1.0 s long instead of 0.5 s");
    }

    @Test
    void aFilmWithoutAllPicturesIsRefused() {
        byte[] film = Mp4Boxes.join(Mp4Boxes.index(30, 60), Mp4Boxes.box("mdat", new byte[299]));

        assertRefused(film, "its pictures are not whole");
    }

    @Test
    void anIndexWithoutContentIsRefused() {
        byte[] film = Mp4Boxes.join(Mp4Boxes.box("moov", new byte[20]), Mp4Boxes.box("mdat", new byte[300]));

        assertRefused(film, "its index is damaged");
    }

    private void assertRefused(byte[] film, String why) {
        assertThatIOException().isThrownBy(() -> check(film)).withMessage(why);
    }

    private void check(byte[] film) throws IOException {
        Path file = Files.write(folder.resolve("film.mp4"), film);
        try (FileChannel channel = FileChannel.open(file)) {
            Mp4File.check(channel, FORMAT);
        }
    }
}
