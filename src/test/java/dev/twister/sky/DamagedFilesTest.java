package dev.twister.sky;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.color.ColorSpace;
import java.awt.color.ICC_Profile;
import java.awt.image.BufferedImage;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import javax.imageio.ImageIO;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Tag;

/** Files with bytes changed, removed or inserted: read, or rejected with one line of text. */
class DamagedFilesTest {
    private static final byte[] PROFILE =
            ICC_Profile.getInstance(ColorSpace.CS_LINEAR_RGB).getData();

    private static final List<byte[]> FILES = files();

    @Tag("slow")
    @Property(tries = 3000)
    void areReadOrRefused(@ForAll long seed) throws IOException {
        Random random = new Random(seed);
        byte[] damaged = damage(FILES.get(random.nextInt(FILES.size())), random);
        Path file = Files.createTempFile("damaged", ".hdr");
        try {
            Files.write(file, damaged);
            List<String> warnings = new ArrayList<>();
            Skybox sky = SkyboxReader.read(file, warnings::add);
            assertThat(warnings).allMatch(warning -> warning.startsWith(file + ": ") && !warning.contains("\n"));
            for (float radiance : sky.radiance()) {
                assertThat(radiance >= 0 && radiance <= Float.MAX_VALUE).isTrue();
            }
        } catch (SkyException refused) {
            assertThat(refused).message().startsWith(file.toString()).doesNotContain("\n");
        } finally {
            Files.delete(file);
        }
    }

    private static byte[] damage(byte[] whole, Random random) {
        byte[] damaged = whole.clone();
        for (int times = random.nextInt(3); times >= 0; times--) {
            // Half of the damage is near the start, where sizes and codes are.
            int reach = random.nextBoolean() ? damaged.length : Math.min(damaged.length, 120);
            int at = random.nextInt(Math.max(1, reach));
            switch (random.nextInt(4)) {
                case 0 -> damaged = Arrays.copyOf(damaged, at);
                case 1 -> damaged = inserted(damaged, at, (byte) random.nextInt(256));
                case 2 -> damaged = inserted(damaged, at, (byte) ('0' + random.nextInt(10)));
                default -> {
                    if (at < damaged.length) {
                        damaged[at] = (byte) random.nextInt(256);
                    }
                }
            }
        }
        return damaged;
    }

    private static byte[] inserted(byte[] bytes, int at, byte value) {
        byte[] longer = Arrays.copyOf(bytes, bytes.length + 1);
        System.arraycopy(bytes, at, longer, at + 1, bytes.length - at);
        longer[at] = value;
        return longer;
    }

    private static List<byte[]> files() {
        byte[] texels = new byte[4 * 16 * 6];
        Arrays.fill(texels, (byte) 130);
        new Random(1).nextBytes(texels);
        String header = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\nEXPOSURE=2\nCOLORCORR=1 2 3\n";
        Arrays.fill(texels, 40, 200, (byte) 130);
        for (int at = 0; at < texels.length; at += 4) {
            texels[at] |= (byte) 0x80;
        }
        return List.of(
                RadianceFiles.file(header, "-Y +X", 16, 6, texels, RadianceFiles.Coding.FLAT),
                RadianceFiles.file(header, "+X -Y", 16, 6, texels, RadianceFiles.Coding.OLD_RUNS),
                RadianceFiles.file(header, "-Y +X", 16, 6, texels, RadianceFiles.Coding.NEW_RUNS),
                image("png", BufferedImage.TYPE_INT_RGB),
                image("png", BufferedImage.TYPE_BYTE_INDEXED),
                image("jpeg", BufferedImage.TYPE_INT_RGB),
                image("jpeg", BufferedImage.TYPE_BYTE_GRAY),
                profiledPng(),
                profiledJpeg());
    }

    private static byte[] profiledPng() {
        return PngBytes.start(2, 8, PngBytes.RGB)
                .chunk("cICP", 9, 8, 0, 1)
                .profile(PROFILE)
                .gamma(70_000)
                .chromaticities(31_270, 32_900, 68_000, 32_000, 26_500, 69_000, 15_000, 6_000)
                .chunk("eXIf", ExifBytes.tiff(true, 7))
                .texels(1, 2, 3, 4, 5, 6);
    }

    private static byte[] profiledJpeg() {
        byte[] jpeg = JpegBytes.of(JpegBytes.image(16, 6, BufferedImage.TYPE_INT_RGB, 0x123456), true);
        return JpegBytes.withExif(JpegBytes.withProfile(jpeg, 1, 1, PROFILE), ExifBytes.tiff(false, 5));
    }

    private static byte[] image(String format, int type) {
        BufferedImage image = new BufferedImage(16, 6, type);
        for (int i = 0; i < 96; i++) {
            image.setRGB(i % 16, i / 16, i * 0x020508);
        }
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        try {
            ImageIO.write(image, format, out);
        } catch (IOException impossible) {
            throw new AssertionError(impossible);
        }
        return out.toByteArray();
    }
}
