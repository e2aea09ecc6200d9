package dev.twister.image;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Random;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class PngWriterTest {
    @TempDir
    Path folder;

    @ParameterizedTest
    @CsvSource({"1, 1", "17, 3", "3, 17", "256, 200", "5000, 1"})
    void readsBackOpaqueAndEqual(int width, int height) throws IOException {
        int[] pixels = new Random(width).ints((long) width * height).toArray();
        Path file = folder.resolve("picture.png");
        PngWriter.write(file, width, height, pixels, true);

        BufferedImage image = ImageIO.read(file.toFile());
        assertThat(image.getWidth()).isEqualTo(width);
        assertThat(image.getHeight()).isEqualTo(height);
        assertThat(image.getColorModel().hasAlpha()).isFalse();
        int[] read = image.getRGB(0, 0, width, height, null, 0, width);
        for (int i = 0; i < read.length; i++) {
            assertThat(read[i]).isEqualTo(pixels[i] | 0xff000000);
        }
    }

    @ParameterizedTest
    @ValueSource(ints = {0, 100, 20_000})
    void theFailureOfTheDiskIsTold(int room) {
        OutputStream full = new OutputStream() {
            private int left = room;

            @Override
            public void write(int value) throws IOException {
                left--;
                if (left < 0) {
                    throw new IOException("No space left on device");
                }
            }
        };
        int[] pixels = new Random(1).ints(300 * 200).toArray();

        assertThatThrownBy(() -> PngWriter.write(full, 300, 200, pixels, true, false, new Provenance("a", "b", "1")))
                .isInstanceOf(IOException.class)
                .hasMessage("No space left on device");
    }

    @ParameterizedTest
    @ValueSource(booleans = {false, true})
    void onlyLinearPixelsCarryAGammaOfOne(boolean srgb) throws IOException {
        Path file = folder.resolve("picture.png");
        PngWriter.write(file, 1, 1, new int[] {0x102030}, srgb);

        byte[] chunk = {0, 0, 0, 4, 'g', 'A', 'M', 'A', 0, 1, (byte) 0x86, (byte) 0xA0};
        String bytes = new String(Files.readAllBytes(file), StandardCharsets.ISO_8859_1);
        assertThat(bytes.contains(new String(chunk, StandardCharsets.ISO_8859_1)))
                .isEqualTo(!srgb);
        assertThat(bytes.contains("gAMA")).isEqualTo(!srgb);
    }

    @Test
    void refusesAnArrayOfAnotherSize() {
        assertThatIllegalArgumentException()
                .isThrownBy(() -> PngWriter.write(folder.resolve("x.png"), 4, 4, new int[15], true))
                .withMessage("a picture of 4 x 4 pixels needs 16 ints, not 15");
    }
}
