package dev.twister.sky.webp;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIOException;

import dev.twister.sky.webp.WebpContainer.WebpImage;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.io.InputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import java.util.stream.Stream;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledIfSystemProperty;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.FieldSource;

/** Compares with texels of libwebp. */
class WebpContainerTest {
    private static final List<String> FILES = List.of(
            "simple-filter",
            "normal-filter",
            "plain-alpha",
            "filtered-alpha",
            "palette",
            "prediction",
            "noise",
            "segments");

    @ParameterizedTest
    @FieldSource("FILES")
    void hasTheTexelsOfLibwebp(String name) throws IOException {
        BufferedImage expected = ImageIO.read(WebpContainerTest.class.getResource("/webp/" + name + ".png"));

        WebpImage image = new WebpContainer(file(name)).decode();

        assertThat(image.width()).isEqualTo(expected.getWidth());
        assertThat(argb(image))
                .isEqualTo(expected.getRGB(
                        0, 0, image.width(), image.height(), new int[image.argb().length], 0, image.width()));
    }

    @Test
    void refusesFilesThatEndEarly() throws IOException {
        for (String name : FILES) {
            byte[] file = file(name);
            for (int length = 12; length < file.length - 1; length += 7) {
                byte[] start = Arrays.copyOf(file, length);

                assertThatIOException()
                        .isThrownBy(() -> new WebpContainer(start).decode())
                        .withMessageContaining("WebP");
            }
        }
    }

    @Test
    void refusesTexelsThatEndEarlyInAWholeFile() throws IOException {
        for (String name : List.of("normal-filter", "noise", "prediction")) {
            byte[] file = file(name);
            byte[] shorter = Arrays.copyOf(file, file.length - file.length / 3 & ~1);
            ByteBuffer sizes = ByteBuffer.wrap(shorter).order(ByteOrder.LITTLE_ENDIAN);
            sizes.putInt(4, shorter.length - 8);
            int chunk = texels(shorter);
            sizes.putInt(chunk + 4, shorter.length - chunk - 8);

            assertThatIOException()
                    .isThrownBy(() -> new WebpContainer(shorter).decode())
                    .withMessage("the WebP ends before its last texel");
        }
    }

    private static int texels(byte[] file) {
        String text = new String(file, StandardCharsets.ISO_8859_1);
        return Math.max(text.indexOf("VP8 "), text.indexOf("VP8L"));
    }

    @Test
    void damagedFilesAreReadOrRefused() throws IOException {
        Random random = new Random(1);
        int mutations = Integer.getInteger("twister.mutations", 2000);
        for (int i = 0; i < mutations; i++) {
            byte[] file = file(FILES.get(i % FILES.size()));
            for (int change = random.nextInt(8); change >= 0; change--) {
                // Not in the size, so that each one is small.
                int at = 30 + random.nextInt(file.length - 30);
                file[at] = (byte) (random.nextBoolean() ? random.nextInt(256) : file[at] ^ 1 << random.nextInt(8));
            }
            readOrRefuse(file);
        }
    }

    private static void readOrRefuse(byte[] file) {
        try {
            WebpContainer webp = new WebpContainer(file);
            if ((long) webp.width() * webp.height() < 1 << 16) {
                webp.decode();
            }
        } catch (IOException refused) {
            assertThat(refused).hasMessageContaining("WebP");
        }
    }

    /** A folder of many files, each NAME.webp beside its red, green, blue and alpha, NAME.rgba. */
    @Tag("slow")
    @EnabledIfSystemProperty(named = "twister.images", matches = ".+")
    @Test
    void hasTheTexelsOfLibwebpInManyFiles() throws IOException {
        String folder = System.getProperty("twister.images");
        try (Stream<Path> files = Files.list(Path.of(folder))) {
            List<Path> webps =
                    files.filter(file -> file.toString().endsWith(".webp")).toList();
            assertThat(webps).hasSizeGreaterThanOrEqualTo(300);
            for (Path file : webps) {
                WebpImage image = new WebpContainer(Files.readAllBytes(file)).decode();
                ByteBuffer rgba = ByteBuffer.allocate(4 * image.argb().length);
                for (int texel : argb(image)) {
                    rgba.putInt(texel << 8 | texel >>> 24);
                }
                assertThat(rgba.array())
                        .as("%s", file)
                        .isEqualTo(Files.readAllBytes(Path.of(file.toString().replace(".webp", ".rgba"))));
            }
        }
    }

    private static int[] argb(WebpImage image) {
        return image.hasAlpha()
                ? image.argb()
                : Arrays.stream(image.argb()).map(texel -> texel | 0xff << 24).toArray();
    }

    private static byte[] file(String name) throws IOException {
        try (InputStream file = WebpContainerTest.class.getResourceAsStream("/webp/" + name + ".webp")) {
            return file.readAllBytes();
        }
    }
}
