package dev.twister.image;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIOException;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.file.Files;
import java.nio.file.Path;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class PngNotesTest {
    private static final int WIDTH_AT = 16;

    @TempDir
    private Path folder;

    private Path file;

    @BeforeEach
    void writePng() throws IOException {
        file = folder.resolve("a.png");
        ImageIO.write(new BufferedImage(5, 3, BufferedImage.TYPE_INT_RGB), "png", file.toFile());
    }

    @Test
    void tellsTheSize() throws IOException {
        assertThat(PngNotes.of(file).size()).isEqualTo(new PictureSize(5, 3));
    }

    @Test
    void refusesMorePixelsThanItsDataCanHold() throws IOException {
        setSize(20_000, 20_000);

        assertThatIOException()
                .isThrownBy(() -> PngNotes.of(file))
                .withMessageStartingWith(file + ": a PNG of 1200000000 bytes cannot come from ");
    }

    @Test
    void refusesSidesThatNoPictureHas() throws IOException {
        setSize(-1, 1);

        assertThatIOException()
                .isThrownBy(() -> PngNotes.of(file))
                .withMessage(file + ": a PNG of 4294967295 x 1 pixels");
    }

    private void setSize(int width, int height) throws IOException {
        byte[] bytes = Files.readAllBytes(file);
        ByteBuffer.wrap(bytes).putInt(WIDTH_AT, width).putInt(WIDTH_AT + Integer.BYTES, height);
        Files.write(file, bytes);
    }
}
