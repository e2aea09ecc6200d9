package dev.twister.sky.image;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import com.sun.management.ThreadMXBean;
import dev.twister.sky.ExifBytes;
import dev.twister.sky.PngBytes;
import dev.twister.sky.Skybox;
import java.awt.color.ColorSpace;
import java.awt.color.ICC_Profile;
import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class PngFileTest {
    private static final float AS_SRGB = 0.2462f;
    private static final float AS_LINEAR = 136 / 255f;
    private static final byte[] LINEAR_RGB =
            ICC_Profile.getInstance(ColorSpace.CS_LINEAR_RGB).getData();
    private static final byte[] SRGB =
            ICC_Profile.getInstance(ColorSpace.CS_sRGB).getData();
    private static final byte[] LINEAR_GRAY =
            ICC_Profile.getInstance(ColorSpace.CS_GRAY).getData();

    private final List<String> warnings = new ArrayList<>();

    @ParameterizedTest
    @ValueSource(strings = {"IDAT", "tEXt"})
    void manyEmptyChunksTakeLittleMoreMemoryThanTheFile(String type) throws IOException {
        PngBytes png = rgb();
        for (int chunk = 0; chunk < 100_000; chunk++) {
            png.chunk(type);
        }
        byte[] file = png.texels(136, 136, 136);
        ThreadMXBean threads = (ThreadMXBean) ManagementFactory.getThreadMXBean();
        read(file);
        long before = threads.getCurrentThreadAllocatedBytes();
        assertThat(read(file)[0]).isCloseTo(AS_SRGB, within(1e-4f));
        assertThat(threads.getCurrentThreadAllocatedBytes() - before).isLessThan(16L * file.length);
    }

    @Test
    void samplesWithoutAWordAboutThemAreSrgb() throws IOException {
        assertThat(red(rgb())).isCloseTo(AS_SRGB, within(1e-4f));
    }

    @ParameterizedTest
    @CsvSource({"8, 2", "16, 2", "8, 6", "16, 6", "8, 0", "16, 0", "8, 4", "16, 4", "4, 0"})
    void takesTheGammaForAnyDepthAndChannels(int bits, int colorType) throws IOException {
        int channels = new int[] {1, 0, 3, 0, 2, 0, 4}[colorType];
        int[] row = new int[Math.max(1, channels * bits / 8)];
        Arrays.fill(row, 0x88);
        if (colorType >= 4) {
            Arrays.fill(row, (channels - 1) * bits / 8, row.length, 0xff);
        }
        byte[] file = PngBytes.start(1, bits, colorType).gamma(100_000).texels(row);
        assertThat(read(file)).containsExactly(new float[] {AS_LINEAR, AS_LINEAR, AS_LINEAR}, within(1e-6f));
        assertThat(warnings).isEmpty();
    }

    @Test
    void takesTheGammaForPalettes() throws IOException {
        byte[] file = PngBytes.start(2, 8, PngBytes.PALETTE)
                .gamma(100_000)
                .chunk("PLTE", 0, 0, 0, 136, 136, 136)
                .chunk("tRNS", 255, 51)
                .texels(1, 0);
        assertThat(read(file)[0]).isCloseTo(AS_LINEAR / 5, within(1e-6f));
    }

    @Test
    void takesAGammaOfAboutOneIn22ForTheSrgbCurve() throws IOException {
        for (int gamma : new int[] {45_455, 45_000, 45_900}) {
            assertThat(red(rgb().gamma(gamma))).isEqualTo(red(rgb()));
        }
        assertThat(red(rgb().gamma(55_556))).isCloseTo((float) Math.pow(136 / 255.0, 1.8), within(1e-4f));
    }

    @ParameterizedTest
    @ValueSource(ints = {0, 1, -1, Integer.MAX_VALUE, 5_000_000})
    void aGammaThatMakesNoSenseCountsAsAbsent(int gamma) throws IOException {
        assertThat(red(rgb().gamma(gamma))).isEqualTo(red(rgb()));
        assertThat(warnings).containsExactly("its gAMA chunk makes no sense and is ignored");
    }

    @Test
    void convertsPrimaries() throws IOException {
        // The red of Display P3, linear: 1.2249, -0.0420, -0.0196 in sRGB.
        byte[] file = PngBytes.start(2, 8, PngBytes.RGB)
                .gamma(100_000)
                .chromaticities(31_270, 32_900, 68_000, 32_000, 26_500, 69_000, 15_000, 6_000)
                .texels(102, 102, 102, 128, 64, 64);
        float[] radiance = read(file);
        for (int channel = 0; channel < 3; channel++) {
            assertThat(radiance[channel]).isCloseTo(0.4f, within(1e-4f));
        }
        assertThat(radiance[3]).isCloseTo(64 / 255f + 1.2249f * 64 / 255f, within(1e-3f));
        assertThat(radiance[4]).isCloseTo(64 / 255f - 0.0420f * 64 / 255f, within(1e-3f));
    }

    @Test
    void leavesTheUsualPrimariesAsTheyAre() throws IOException {
        PngBytes usual =
                rgb().gamma(45_455).chromaticities(31_270, 32_900, 64_000, 33_000, 30_000, 60_000, 15_000, 6_000);
        assertThat(red(usual)).isEqualTo(red(rgb()));
    }

    @Test
    void primariesThatMakeNoSenseCountAsAbsent() throws IOException {
        assertThat(red(rgb().chromaticities(0, 0, 0, 0, 0, 0, 0, 0))).isEqualTo(red(rgb()));
        assertThat(red(rgb().chromaticities(31_270, 32_900))).isEqualTo(red(rgb()));
        assertThat(warnings)
                .hasSize(2)
                .allMatch(warning -> warning.equals("its cHRM chunk makes no sense and is ignored"));
    }

    @Test
    void takesTheProfile() throws IOException {
        assertThat(red(rgb().profile(LINEAR_RGB))).isCloseTo(AS_LINEAR, within(1e-3f));
        byte[] gray = PngBytes.start(1, 8, PngBytes.GRAY).profile(LINEAR_GRAY).texels(136);
        assertThat(read(gray)).containsExactly(new float[] {AS_LINEAR, AS_LINEAR, AS_LINEAR}, within(1e-3f));
        byte[] palette = PngBytes.start(1, 8, PngBytes.PALETTE)
                .profile(LINEAR_RGB)
                .chunk("PLTE", 136, 136, 136)
                .texels(0);
        assertThat(read(palette)[0]).isCloseTo(AS_LINEAR, within(1e-3f));
        byte[] alpha = PngBytes.start(1, 16, PngBytes.RGBA)
                .profile(LINEAR_RGB)
                .texels(136, 136, 136, 136, 136, 136, 0x33, 0x33);
        assertThat(read(alpha)[0]).isCloseTo(AS_LINEAR / 5, within(1e-3f));
        assertThat(warnings).isEmpty();
    }

    @Test
    void anSrgbProfileChangesNothing() throws IOException {
        assertThat(red(rgb().profile(SRGB))).isEqualTo(red(rgb()));
    }

    @Test
    void aProfileThatCannotBeUsedIsIgnoredWithAWarning() throws IOException {
        byte[] truncated = Arrays.copyOf(LINEAR_RGB, LINEAR_RGB.length / 2);
        assertThat(red(rgb().profile(truncated))).isEqualTo(red(rgb()));
        assertThat(red(rgb().chunk("iCCP", 'p', 0, 0, 1, 2, 3))).isEqualTo(red(rgb()));
        assertThat(red(rgb().chunk("iCCP", new byte[0]))).isEqualTo(red(rgb()));
        assertThat(warnings)
                .hasSize(3)
                .allMatch(warning -> warning.equals("its color profile is damaged and is ignored"));
        warnings.clear();
        assertThat(red(rgb().profile(LINEAR_GRAY))).isEqualTo(red(rgb()));
        byte[] gray = PngBytes.start(1, 8, PngBytes.GRAY).profile(LINEAR_RGB).texels(136);
        assertThat(read(gray)[0]).isCloseTo(AS_SRGB, within(1e-4f));
        assertThat(warnings)
                .hasSize(2)
                .allMatch(warning -> warning.equals("its color profile is for another kind of image and is ignored"));
    }

    @Test
    void theMoreExactChunkWins() throws IOException {
        assertThat(red(rgb().gamma(100_000).chunk("sRGB", 0))).isCloseTo(AS_SRGB, within(1e-4f));
        assertThat(red(rgb().chunk("sRGB", 0).profile(LINEAR_RGB))).isCloseTo(AS_LINEAR, within(1e-3f));
        assertThat(red(rgb().profile(LINEAR_RGB).chunk("cICP", 1, 13, 0, 1))).isCloseTo(AS_SRGB, within(1e-4f));
        assertThat(red(rgb().chunk("cICP", 1, 8, 0, 1))).isCloseTo(AS_LINEAR, within(1e-6f));
        assertThat(warnings).isEmpty();
        assertThat(red(rgb().gamma(100_000).chunk("cICP", 9, 16, 0, 1))).isCloseTo(AS_LINEAR, within(1e-6f));
        assertThat(warnings).containsExactly("its cICP chunk names colors that are not supported and is ignored");
    }

    @ParameterizedTest
    @CsvSource({"1, 1, 0x40", "2, 3, 0x30", "4, 15, 0x0f", "8, 255, 0xff"})
    void transparentGrayIsBlackAtAnyDepth(int bits, int key, String row) throws IOException {
        int[] texels = bits == 8 ? new int[] {0, Integer.decode(row)} : new int[] {Integer.decode(row)};
        byte[] file =
                PngBytes.start(2, bits, PngBytes.GRAY).chunk("tRNS", 0, key).texels(texels);
        byte[] opaque = PngBytes.start(2, bits, PngBytes.GRAY).texels(texels);
        assertThat(read(opaque)[3]).isOne();
        assertThat(read(file)).containsOnly(0);
    }

    @Test
    void transparentColorsOfSixteenBitsAreBlack() throws IOException {
        byte[] gray = PngBytes.start(2, 16, PngBytes.GRAY)
                .gamma(100_000)
                .chunk("tRNS", 0x88, 0x88)
                .texels(0x88, 0x88, 0x88, 0x89);
        assertThat(read(gray)[0]).isZero();
        assertThat(read(gray)[3]).isCloseTo(AS_LINEAR, within(1e-4f));
        byte[] rgb = PngBytes.start(2, 16, PngBytes.RGB)
                .chunk("tRNS", 1, 2, 3, 4, 5, 6)
                .texels(1, 2, 3, 4, 5, 6, 1, 2, 3, 4, 5, 7);
        assertThat(read(rgb)[0]).isZero();
        assertThat(read(rgb)[3]).isPositive();
    }

    @Test
    void aWrongChecksumInAnAncillaryChunkIsNoDamage() throws IOException {
        assertThat(red(rgb().damagedChunk("tEXt", new byte[] {'a', 0, 'b'}))).isEqualTo(red(rgb()));
        assertThat(red(rgb().chunk("zTXt", new byte[0]).chunk("tIME", 1).chunk("hIST", 1)))
                .isEqualTo(red(rgb()));
        assertThat(warnings).isEmpty();
        assertThat(red(rgb().damagedChunk("gAMA", new byte[] {0, 1, (byte) 0x86, (byte) 0xa0})))
                .isEqualTo(red(rgb()));
        assertThat(warnings).containsExactly("the gAMA chunk is damaged and is ignored");
    }

    @Test
    void aWrongChecksumInACriticalChunkIsDamage() {
        PngBytes damaged = PngBytes.start(1, 8, PngBytes.PALETTE).damagedChunk("PLTE", new byte[] {1, 2, 3});
        assertThatThrownBy(() -> read(damaged.texels(0)))
                .hasMessage("a damaged PNG: the checksum of its PLTE chunk does not match");
    }

    @Test
    void readsDataInManyChunks() throws IOException {
        PngBytes png = rgb();
        for (byte one : PngBytes.deflated(new byte[] {0, (byte) 136, (byte) 136, (byte) 136})) {
            png.chunk("IDAT", one).chunk("IDAT", new byte[0]);
        }
        assertThat(read(png.end())[0]).isEqualTo(red(rgb()));
    }

    @Test
    void turnsAsItsExifDataSay() throws IOException {
        byte[] file = PngBytes.start(2, 8, PngBytes.GRAY)
                .chunk("eXIf", ExifBytes.tiff(false, 6))
                .texels(0, 255);
        Skybox sky = SkyBytes.read(file);
        assertThat(sky.height()).isEqualTo(2);
        assertThat(sky.radiance()).containsExactly(0, 0, 0, 1, 1, 1);
    }

    /** One texel of 136, 136, 136. */
    private static PngBytes rgb() {
        return PngBytes.start(1, 8, PngBytes.RGB);
    }

    private float red(PngBytes png) throws IOException {
        return read(png.texels(136, 136, 136))[0];
    }

    private float[] read(byte[] file) throws IOException {
        return SkyBytes.read(file, warnings).radiance();
    }
}
