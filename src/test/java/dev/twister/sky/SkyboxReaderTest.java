package dev.twister.sky;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import dev.twister.image.ExrPicture.ExrChannel;
import dev.twister.image.ExrWriter;
import dev.twister.image.HdrWriter;
import dev.twister.image.PngWriter;
import dev.twister.sky.image.CurveEncoding;
import dev.twister.sky.image.FileBytes;
import java.awt.Transparency;
import java.awt.color.ColorSpace;
import java.awt.image.BufferedImage;
import java.awt.image.ComponentColorModel;
import java.awt.image.DataBuffer;
import java.awt.image.IndexColorModel;
import java.io.IOException;
import java.nio.channels.FileChannel;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class SkyboxReaderTest {
    /** sRGB 188 of 255 is linear 0.5029. */
    private static final float HALF = 0.50289f;

    @TempDir
    Path folder;

    @Test
    void readsWhatTheHdrWriterWrote() throws IOException {
        float[] radiance = {1, 2, 4, 0, 0, 0, 1000, 500, 248};
        Path file = folder.resolve("named.png");
        HdrWriter.write(file, 3, 1, radiance);
        assertThat(SkyboxReader.read(file).radiance()).containsExactly(radiance);
    }

    @Test
    void whatTheHdrWriterWritesIsFinite() throws IOException {
        float[] radiance = {Float.POSITIVE_INFINITY, Float.MAX_VALUE, Float.NaN, 3e38f, Float.NEGATIVE_INFINITY, 0};
        Path file = folder.resolve("bright.hdr");
        HdrWriter.write(file, 2, 1, radiance);
        float largest = 255 * 0x1p119f;
        assertThat(SkyboxReader.read(file).radiance()).containsExactly(largest, largest, 0, largest, 0, 0);
    }

    @Test
    void readsBothWaysTheHdrWriterWrites() throws IOException {
        for (int width : new int[] {7, 8, 500, 32768}) {
            float[] radiance = new float[3 * width * 2];
            for (int i = 0; i < radiance.length; i++) {
                radiance[i] = i / 60 % 3 == 0 ? 0.5f : (i * 37 % 256) / 64f;
            }
            Path file = folder.resolve(width + ".hdr");
            HdrWriter.write(file, width, 2, radiance);
            if (width > SkyboxLimits.WIDTH) {
                assertThatThrownBy(() -> SkyboxReader.read(file))
                        .hasMessage(file + ": 32768 x 2 texels; 1 x 1 to 16384 x 8192 are allowed");
                assertThat(Files.size(file)).isGreaterThan(4L * width * 2);
            } else {
                float[] read = SkyboxReader.read(file).radiance();
                for (int i = 0; i < read.length; i++) {
                    assertThat(read[i]).isCloseTo(radiance[i], within(4 / 256f));
                }
            }
        }
    }

    @Test
    void makesSrgbLinear() throws IOException {
        Path file = folder.resolve("sky.hdr");
        PngWriter.write(file, 2, 1, new int[] {0xffbc00, 0x0a0000}, true);
        assertRadiance(file, 1, HALF, 0, 10 / 255f / 12.92f, 0, 0);
    }

    @Test
    void readsGrayAsSrgb() throws IOException {
        BufferedImage gray = new BufferedImage(1, 1, BufferedImage.TYPE_BYTE_GRAY);
        gray.getRaster().setSample(0, 0, 0, 188);
        assertRadiance(png(gray), HALF, HALF, HALF);
        BufferedImage deep = new BufferedImage(1, 1, BufferedImage.TYPE_USHORT_GRAY);
        deep.getRaster().setSample(0, 0, 0, 188 * 257);
        assertRadiance(png(deep), HALF, HALF, HALF);
    }

    @Test
    void readsSixteenBitsAtFullDepth() throws IOException {
        ComponentColorModel model = new ComponentColorModel(
                ColorSpace.getInstance(ColorSpace.CS_sRGB), false, false, Transparency.OPAQUE, DataBuffer.TYPE_USHORT);
        BufferedImage image = new BufferedImage(model, model.createCompatibleWritableRaster(2, 1), false, null);
        image.getRaster().setPixel(0, 0, new int[] {65535, 30000, 1});
        image.getRaster().setPixel(1, 0, new int[] {30001, 188 * 257, 0});
        float[] read = SkyboxReader.read(png(image)).radiance();
        assertThat(read[1]).isEqualTo((float) CurveEncoding.linear(30000 / 65535.0));
        assertThat(read[2]).isEqualTo((float) (1 / 65535.0 / 12.92));
        assertThat(read[3]).isGreaterThan(read[1]);
        assertThat(read[4]).isCloseTo(HALF, within(1e-4f));
    }

    @Test
    void readsPalettes() throws IOException {
        byte[] reds = {0, (byte) 188, (byte) 255, 0};
        byte[] zeros = new byte[4];
        BufferedImage image =
                new BufferedImage(4, 1, BufferedImage.TYPE_BYTE_INDEXED, new IndexColorModel(2, 4, reds, zeros, zeros));
        for (int i = 0; i < 4; i++) {
            image.getRaster().setSample(i, 0, 0, i);
        }
        assertRadiance(png(image), 0, 0, 0, HALF, 0, 0, 1, 0, 0, 0, 0, 0);
    }

    @Test
    void putsTransparentTexelsOverBlack() throws IOException {
        BufferedImage image = new BufferedImage(2, 1, BufferedImage.TYPE_INT_ARGB);
        image.setRGB(0, 0, 0x00ffffff);
        image.setRGB(1, 0, 0x33ffffff);
        assertRadiance(png(image), 0, 0, 0, 0.2f, 0.2f, 0.2f);
    }

    @Test
    void readsJpeg() throws IOException {
        BufferedImage image = new BufferedImage(16, 8, BufferedImage.TYPE_INT_RGB);
        for (int i = 0; i < 128; i++) {
            image.setRGB(i % 16, i / 16, 0xbcbcbc);
        }
        Path file = folder.resolve("sky.jpg");
        ImageIO.write(image, "jpeg", file.toFile());
        Skybox sky = SkyboxReader.read(file);
        assertThat(sky.width()).isEqualTo(16);
        assertThat(sky.radiance()[0]).isCloseTo(HALF, within(0.01f));

        byte[] whole = Files.readAllBytes(file);
        Files.write(file, Arrays.copyOf(whole, whole.length - 4));
        assertThatThrownBy(() -> SkyboxReader.read(file)).isInstanceOf(SkyException.class);
    }

    @Test
    void saysWhatIsWrongWithTheFile() throws IOException {
        Path missing = folder.resolve("missing.hdr");
        assertThatThrownBy(() -> SkyboxReader.read(missing))
                .isInstanceOf(SkyException.class)
                .hasMessage(missing + ": file not found");
        assertThatThrownBy(() -> SkyboxReader.read(folder)).hasMessage(folder + ": is a folder, but must be a file");
        Path empty = Files.write(folder.resolve("empty.hdr"), new byte[0]);
        assertThatThrownBy(() -> SkyboxReader.read(empty))
                .hasMessage(empty + ": an empty file; Radiance, OpenEXR, PNG, JPEG and WebP are read");
        Path text = Files.writeString(folder.resolve("text.hdr"), "hello");
        assertThatThrownBy(() -> SkyboxReader.read(text)).hasMessageContaining("not a panorama by its first bytes");
    }

    @Test
    void readsOpenExr() throws IOException {
        Path exr = folder.resolve("sky.exr");
        ExrWriter.write(
                exr,
                2,
                1,
                List.of(
                        new ExrChannel("sky.R", new float[] {7, Float.NaN}, 0, 1),
                        new ExrChannel("sky.G", new float[] {0.25f, -1}, 0, 1),
                        new ExrChannel("sky.B", new float[] {0, Float.POSITIVE_INFINITY}, 0, 1)));
        List<String> warnings = new ArrayList<>();

        Skybox sky = SkyboxReader.read(exr, warnings::add);

        assertThat(sky.width()).isEqualTo(2);
        assertThat(sky.radiance()).containsExactly(7, 0.25f, 0, 0, 0, 0);
        assertThat(warnings).containsExactly(exr + ": 3 values are negative or not finite and count as 0");
    }

    @Test
    void saysThatTheFileBecameShorterWhileItWasLookedThrough() throws IOException {
        Path hdr = folder.resolve("sky.hdr");
        HdrWriter.write(hdr, 4, 8000, new float[3 * 4 * 8000]);
        byte[] png = PngBytes.start(16_384, 16, PngBytes.RGBA).texels(noise(131_072));
        for (byte[] content : List.of(Files.readAllBytes(hdr), png, largeJpeg())) {
            assertShortened(content, true);
        }
    }

    @Test
    void saysThatTheFileBecameShorterWhileItWasDecoded() throws IOException {
        byte[] warned = JpegBytes.withProfile(largeJpeg(), 1, 2, new byte[9]);
        assertShortened(warned, false);
    }

    /** Reads a file that is truncated after its first bytes are read, or at the first warning. */
    private void assertShortened(byte[] content, boolean atOnce) throws IOException {
        Path file = Files.write(folder.resolve("shortened"), content);
        try (FileChannel channel = FileChannel.open(file, StandardOpenOption.READ, StandardOpenOption.WRITE)) {
            FileBytes bytes = new FileBytes(channel);
            if (atOnce) {
                bytes.at(0);
                truncate(channel);
            }
            assertThatThrownBy(() -> SkyboxReader.decode(bytes, warning -> truncate(channel)))
                    .isInstanceOf(IOException.class)
                    .hasMessage("the file was changed while it was read; try again");
        }
    }

    private static void truncate(FileChannel channel) {
        try {
            channel.truncate(100);
        } catch (IOException impossible) {
            throw new AssertionError(impossible);
        }
    }

    private static byte[] largeJpeg() {
        BufferedImage image = new BufferedImage(800, 500, BufferedImage.TYPE_BYTE_GRAY);
        image.getRaster().setDataElements(0, 0, 800, 500, noise(400_000));
        return JpegBytes.of(image, false);
    }

    private static byte[] noise(int bytes) {
        byte[] noise = new byte[bytes];
        new Random(1).nextBytes(noise);
        return noise;
    }

    private Path png(BufferedImage image) throws IOException {
        Path file = folder.resolve("image.png");
        assertThat(ImageIO.write(image, "png", file.toFile())).isTrue();
        return file;
    }

    private static void assertRadiance(Path file, float... expected) {
        assertThat(SkyboxReader.read(file).radiance()).containsExactly(expected, within(1e-4f));
    }
}
