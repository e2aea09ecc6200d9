package dev.twister.film;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIOException;

import java.awt.image.BufferedImage;
import java.io.ByteArrayInputStream;
import java.io.DataInputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.zip.InflaterInputStream;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class AnimatedPngTest {
    private static final int[][] FRAMES = {
        {0xff102030, 0xff405060, 0xff708090, 0xffa0b0c0}, {0xffffffff, 0xff000000, 0xff00ff00, 0xff0000ff}
    };

    @TempDir
    private Path folder;

    @SuppressWarnings("ArrayRecordComponent") // never compared
    private record Chunk(String type, byte[] data) {}

    @Test
    void hasEveryFrameWithItsTime() throws IOException {
        Path file = folder.resolve("film.apng");
        try (FilmEncoder film = AnimatedPng.begin(file, new FilmFormat(2, 2, 60, 2, false))) {
            film.add(FRAMES[0]);
            film.add(FRAMES[1]);
            film.finish();
        }

        BufferedImage first = ImageIO.read(file.toFile());
        assertThat(first.getRGB(0, 0, 2, 2, null, 0, 2)).isEqualTo(FRAMES[0]);
        List<Chunk> chunks = chunks(file);
        assertThat(chunks)
                .extracting(Chunk::type)
                .containsExactly("IHDR", "sRGB", "acTL", "fcTL", "IDAT", "fcTL", "fdAT", "IEND");
        assertThat(ByteBuffer.wrap(chunks.get(2).data()).getInt()).isEqualTo(2);
        ByteBuffer control = ByteBuffer.wrap(chunks.get(5).data());
        assertThat(control.getInt(0)).isEqualTo(1);
        assertThat(control.getShort(20)).isEqualTo((short) 1);
        assertThat(control.getShort(22)).isEqualTo((short) 60);
        byte[] second = chunks.get(6).data();
        assertThat(ByteBuffer.wrap(second).getInt()).isEqualTo(2);
        assertThat(new InflaterInputStream(new ByteArrayInputStream(second, 4, second.length - 4)).readAllBytes())
                .containsExactly(2, -1, -1, -1, 0, 0, 0, 2, 1, 0, 1, 0, 0, -1);
    }

    @Test
    void keepsAlpha() throws IOException {
        Path file = folder.resolve("film.apng");
        int[] pixels = {0x00000000, 0x40102030, 0x80ff0000, 0xffa0b0c0};
        try (FilmEncoder film = AnimatedPng.begin(file, new FilmFormat(2, 2, 60, 1, true))) {
            film.add(pixels);
            film.finish();
        }

        assertThat(ImageIO.read(file.toFile()).getRGB(0, 0, 2, 2, null, 0, 2)).isEqualTo(pixels);
    }

    @Test
    void isRefusedIfFramesAreMissing() throws IOException {
        Path file = Files.writeString(folder.resolve("film.apng"), "earlier");
        try (FilmEncoder film = AnimatedPng.begin(file, new FilmFormat(2, 2, 60, 2, false))) {
            film.add(FRAMES[0]);

            assertThatIOException()
                    .isThrownBy(film::finish)
                    .withMessage("cannot write " + file + ": it has 1 of 2 frames");
        }
        assertThat(file).hasContent("earlier");
        assertThat(folder.toFile().list()).hasSize(1);
    }

    private static List<Chunk> chunks(Path file) throws IOException {
        byte[] bytes = Files.readAllBytes(file);
        List<Chunk> chunks = new ArrayList<>();
        try (DataInputStream in =
                new DataInputStream(new ByteArrayInputStream(Arrays.copyOfRange(bytes, 8, bytes.length)))) {
            while (in.available() > 0) {
                int length = in.readInt();
                String type = new String(in.readNBytes(4), StandardCharsets.US_ASCII);
                chunks.add(new Chunk(type, in.readNBytes(length)));
                in.skipNBytes(4);
            }
        }
        return chunks;
    }
}
