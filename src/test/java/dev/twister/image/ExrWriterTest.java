package dev.twister.image;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import dev.twister.image.ExrPicture.ExrChannel;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Reads written files back with an independent reader. */
@EnabledOnOs(value = OS.LINUX, architectures = "amd64")
class ExrWriterTest {
    @TempDir
    private Path folder;

    /** Odd counts of bytes and rows, a shorter last chunk, and incompressible noise. */
    @ParameterizedTest
    @CsvSource({"1, 1", "1, 16", "17, 1", "31, 17", "5, 33", "64, 48"})
    void everyBitComesBack(int width, int height) throws IOException {
        Random random = new Random(width + 100L * height);
        float[] noise = new float[3 * width * height];
        float[] smooth = new float[width * height];
        for (int i = 0; i < noise.length; i++) {
            noise[i] = Float.intBitsToFloat(random.nextInt(0x7F800000)) * (random.nextBoolean() ? 1 : -1);
        }
        for (int i = 0; i < smooth.length; i++) {
            smooth[i] = (float) Math.floor(i / 8.0);
        }
        Path file = folder.resolve("picture.exr");

        ExrWriter.write(
                file,
                width,
                height,
                List.of(
                        new ExrChannel("R", noise, 0, 3),
                        new ExrChannel("depth.Z", smooth, 0, 1),
                        new ExrChannel("G", noise, 1, 3),
                        new ExrChannel("B", noise, 2, 3)));

        ExrFile read = ExrFile.read(file);
        assertThat(read.width()).isEqualTo(width);
        assertThat(read.height()).isEqualTo(height);
        assertThat(read.channels().keySet()).containsExactly("B", "G", "R", "depth.Z");
        assertThat(read.channels().get("depth.Z")).isEqualTo(smooth);
        for (int channel = 0; channel < 3; channel++) {
            float[] values = read.channels().get(List.of("R", "G", "B").get(channel));
            for (int pixel = 0; pixel < values.length; pixel++) {
                assertThat(values[pixel]).isEqualTo(noise[3 * pixel + channel]);
            }
        }
    }

    @Test
    void evenPicturesBecomeSmall() throws IOException {
        Path file = folder.resolve("even.exr");
        ExrWriter.write(file, 320, 180, List.of(new ExrChannel("Y", new float[320 * 180], 0, 1)));
        assertThat(file.toFile().length()).isLessThan(4 * 320 * 180 / 50);
    }

    @Test
    void refusesAChannelThatIsTooShort() {
        ExrChannel channel = new ExrChannel("Y", new float[7], 0, 2);
        assertThatThrownBy(() -> ExrWriter.write(folder.resolve("a.exr"), 5, 1, List.of(channel)))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessage("channel Y of 5 x 1 pixels has 7 floats");
    }
}
