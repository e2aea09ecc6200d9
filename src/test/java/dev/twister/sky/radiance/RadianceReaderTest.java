package dev.twister.sky.radiance;

import static dev.twister.sky.RadianceFiles.ascii;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import dev.twister.sky.RadianceFiles;
import dev.twister.sky.Skybox;
import dev.twister.sky.image.SkyBytes;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;

class RadianceReaderTest {
    private static final String HEADER = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n";

    private static final String[] ORIENTATIONS = {"-Y +X", "-Y -X", "+Y +X", "+Y -X", "+X -Y", "-X -Y", "+X +Y", "-X +Y"
    };

    @ParameterizedTest
    @EnumSource(RadianceFiles.Coding.class)
    void readsEveryOrientationExactly(RadianceFiles.Coding coding) throws IOException {
        byte[] texels = texels(300, 9);
        for (String orientation : ORIENTATIONS) {
            byte[] file = RadianceFiles.file(HEADER, orientation, 300, 9, texels, coding);
            Skybox sky = read(file);
            assertThat(sky.width()).as(orientation).isEqualTo(300);
            assertThat(sky.height()).as(orientation).isEqualTo(9);
            assertThat(sky.radiance()).as(orientation).containsExactly(expected(texels, 1, 1, 1));
        }
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 2, 7})
    void readsNarrowPictures(int width) throws IOException {
        byte[] texels = texels(width, 5);
        for (RadianceFiles.Coding coding :
                new RadianceFiles.Coding[] {RadianceFiles.Coding.FLAT, RadianceFiles.Coding.OLD_RUNS}) {
            Skybox sky = read(RadianceFiles.file(HEADER, "-Y +X", width, 5, texels, coding));
            assertThat(sky.radiance()).containsExactly(expected(texels, 1, 1, 1));
        }
    }

    @Test
    void readsCodingsMixedFromLineToLine() throws IOException {
        byte[] row = texels(20, 1);
        ByteArrayOutputStream file = new ByteArrayOutputStream();
        file.writeBytes(ascii(HEADER + "\n-Y 3 +X 20\n"));
        for (RadianceFiles.Coding coding : RadianceFiles.Coding.values()) {
            byte[] one = RadianceFiles.file("", "-Y +X", 20, 1, row, coding);
            int start = "\n-Y 1 +X 20\n".length();
            file.write(one, start, one.length - start);
        }
        float[] line = expected(row, 1, 1, 1);
        float[] radiance = read(file.toByteArray()).radiance();
        for (int i = 0; i < radiance.length; i++) {
            assertThat(radiance[i]).isEqualTo(line[i % line.length]);
        }
    }

    @Test
    void dividesByEveryExposureAndCorrection() throws IOException {
        byte[] texels = texels(10, 2);
        String header = HEADER + "EXPOSURE=2\nEXPOSURE= 4.0\nCOLORCORR=1 2 0.5\n# a comment\nVIEW=-vta\n"
                + "\tEXPOSURE=100\nCOLORCORR= 0.5  1 1\n";
        Skybox sky = read(RadianceFiles.file(header, "-Y +X", 10, 2, texels, RadianceFiles.Coding.NEW_RUNS));
        assertThat(sky.radiance()).containsExactly(expected(texels, 4, 16, 4));
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "#?RGBE\n",
                "#?RADIANCE\r\nFORMAT=32-bit_rle_rgbe\r\n",
                "#?RADIANCE\nSOFTWARE=x\n",
                "#?AUTOPANO\n",
                "#?my program 2.0\n",
                "#?\n"
            })
    void toleratesOtherHeaders(String header) throws IOException {
        byte[] texels = texels(9, 3);
        byte[] file = RadianceFiles.file(header, "-Y +X", 9, 3, texels, RadianceFiles.Coding.NEW_RUNS);
        assertThat(read(file).radiance()).containsExactly(expected(texels, 1, 1, 1));
    }

    @Test
    void keepsRadianceAboveOne() throws IOException {
        byte[] file = RadianceFiles.file(
                HEADER, "-Y +X", 1, 1, new byte[] {(byte) 200, 100, 0, (byte) 150}, RadianceFiles.Coding.FLAT);
        assertThat(read(file).radiance()).containsExactly(200 * 16384f, 100 * 16384f, 0);
    }

    @ParameterizedTest
    @ValueSource(strings = {"rgbe", "xyze"})
    void aTinyExposureMakesNothingButVeryBright(String format) throws IOException {
        String header = "#?RADIANCE\nFORMAT=32-bit_rle_" + format + "\nEXPOSURE=1e-307\n";
        byte[] texels = {(byte) 128, 0, 0, (byte) 200, (byte) 128, (byte) 128, (byte) 128, (byte) 255};

        float[] radiance = read(RadianceFiles.file(header, "-Y +X", 2, 1, texels, RadianceFiles.Coding.FLAT))
                .radiance();

        assertThat(radiance[0]).isEqualTo(Float.MAX_VALUE);
        assertThat(radiance[1]).isZero();
        for (int channel = 3; channel < 6; channel++) {
            assertThat(radiance[channel]).isEqualTo(Float.MAX_VALUE);
        }
    }

    @Test
    void turnsXyzIntoRgbOfTheSameWhite() throws IOException {
        byte[] texels = {(byte) 128, (byte) 128, (byte) 128, (byte) 129, (byte) 132, 68, 6, (byte) 129};
        String header = "#?RADIANCE\nFORMAT=32-bit_rle_xyze\n";
        float[] rgb = read(RadianceFiles.file(header, "-Y +X", 2, 1, texels, RadianceFiles.Coding.FLAT))
                .radiance();
        for (int channel = 0; channel < 3; channel++) {
            assertThat(rgb[channel]).isCloseTo(1f, within(1e-6f));
        }
        // XYZ of the red primary is (0.5141, 0.2651, 0.0241).
        assertThat(rgb[3]).isCloseTo(2f, within(0.02f));
        assertThat(rgb[4]).isCloseTo(0f, within(0.02f));
        assertThat(rgb[5]).isCloseTo(0f, within(0.02f));
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "-Y 2147483648 +X 2",
                "-Y 99999999999999999999 +X 2",
                "-Y -5 +X 2",
                "-Y 0 +X 2",
                "-Y 8193 +X 2",
                "-Y 2 +X 16385",
                "+X 16385 -Y 2",
                "-Y 2 -Y 2",
                "-Y 8192 +X 16384",
                "-Y 2 +X",
                "so what"
            })
    void refusesOtherSizes(String resolution) {
        assertThatThrownBy(() -> read(ascii(HEADER + "\n" + resolution + "\nsome texels")))
                .isInstanceOf(IOException.class);
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "EXPOSURE=0",
                "EXPOSURE=-1",
                "EXPOSURE=",
                "EXPOSURE=1,5",
                "EXPOSURE=NaN",
                "EXPOSURE=nan",
                "EXPOSURE=inf",
                "EXPOSURE=Infinity",
                "EXPOSURE=1e999",
                "EXPOSURE=bright",
                "EXPOSURE=2 3",
                "COLORCORR=0 0 0",
                "COLORCORR=1 2",
                "COLORCORR=1 2 0",
                "COLORCORR=1 2 -3",
                "COLORCORR=1, 2, 3",
                "COLORCORR=",
                "PRIMARIES=0 0 0 0 0 0 0 0",
                "PRIMARIES=.64 .33 .29 .60 .15 .06",
                "PRIMARIES=nan nan nan nan nan nan nan nan",
                "PRIMARIES=.64 .33 .29 .60 .15 .06 .9 .05"
            })
    void valuesThatMakeNoSenseCountAsAbsent(String line) throws IOException {
        byte[] texels = texels(10, 2);
        String header = HEADER + "EXPOSURE=2\n" + line + "\nCOLORCORR=1 2 4\n";
        Skybox sky = read(RadianceFiles.file(header, "-Y +X", 10, 2, texels, RadianceFiles.Coding.NEW_RUNS));
        assertThat(sky.radiance()).containsExactly(expected(texels, 2, 4, 8));
    }

    @Test
    void exposuresBeyondAllNumbersCountAsAbsent() throws IOException {
        byte[] texels = texels(10, 2);
        String header = HEADER + "EXPOSURE=4e200\nEXPOSURE=1e200\nCOLORCORR=1e200 1 1\nEXPOSURE=0.5e-200\n";
        Skybox sky = read(RadianceFiles.file(header, "-Y +X", 10, 2, texels, RadianceFiles.Coding.NEW_RUNS));
        assertThat(sky.radiance()).containsExactly(expected(texels, 2e200, 2, 2));
    }

    @Test
    void refusesOtherFormats() {
        assertThatThrownBy(() -> read(ascii("#?RADIANCE\nFORMAT=64-bit\n\n-Y 1 +X 1\n\1\2\3\4")))
                .hasMessage("FORMAT=64-bit; 32-bit_rle_rgbe and 32-bit_rle_xyze are read");
    }

    @ParameterizedTest
    @ValueSource(strings = {".64 .33 .29 .60 .15 .06 .333 .333", "0.64 0.33 0.3 0.6 0.15 0.06 0.3127 0.329"})
    void theUsualPrimariesChangeNothing(String primaries) throws IOException {
        byte[] texels = texels(10, 2);
        String header = HEADER + "PRIMARIES=" + primaries + "\n";
        Skybox sky = read(RadianceFiles.file(header, "-Y +X", 10, 2, texels, RadianceFiles.Coding.NEW_RUNS));
        assertThat(sky.radiance()).containsExactly(expected(texels, 1, 1, 1));
    }

    @Test
    void convertsOtherPrimaries() throws IOException {
        String header = HEADER + "PRIMARIES= .708 .292 .170 .797 .131 .046 .3127 .3290\n";
        byte[] texels = {(byte) 128, (byte) 128, (byte) 128, (byte) 131, (byte) 128, 64, 64, (byte) 129};
        float[] rgb = read(RadianceFiles.file(header, "-Y +X", 2, 1, texels, RadianceFiles.Coding.FLAT))
                .radiance();
        for (int channel = 0; channel < 3; channel++) {
            assertThat(rgb[channel]).isCloseTo(4f, within(1e-4f));
        }
        // BT.2020 to BT.709 (ITU-R BT.2087): 1.6605, -0.1246 and -0.0182 from red.
        assertThat(rgb[3]).isCloseTo(0.5f + 0.5f * 1.6605f, within(1e-3f));
        assertThat(rgb[4]).isCloseTo(0.5f - 0.5f * 0.1246f, within(1e-3f));
        assertThat(rgb[5]).isCloseTo(0.5f - 0.5f * 0.0182f, within(1e-3f));
    }

    @Test
    void adaptsAnotherWhite() throws IOException {
        String header = HEADER + "PRIMARIES=.64 .33 .21 .71 .15 .06 .3457 .3585\n";
        byte[] texels = {(byte) 128, (byte) 128, (byte) 128, (byte) 129};
        float[] rgb = read(RadianceFiles.file(header, "-Y +X", 1, 1, texels, RadianceFiles.Coding.FLAT))
                .radiance();
        for (int channel = 0; channel < 3; channel++) {
            assertThat(rgb[channel]).isCloseTo(1f, within(1e-4f));
        }
    }

    @Test
    void refusesAHeaderWithoutEnd() {
        assertThatThrownBy(() -> read(ascii("#?RADIANCE\n" + "x".repeat(100_000))))
                .hasMessageStartingWith("a Radiance header without end");
        assertThatThrownBy(() -> read(ascii("#?RADIANCE\n" + "x\n".repeat(100_000))))
                .hasMessageStartingWith("a Radiance header without end");
    }

    @Test
    void refusesBrokenRuns() {
        String start = HEADER + "\n-Y 1 +X 8\n";
        byte[] zero = {2, 2, 0, 8, 0, 5, 0, 5, 0, 5, 0, 5, 0, 5, 0, 5};
        byte[] long8 = {2, 2, 0, 8, (byte) 137, 5, 0, 5, 0, 5, 0, 5, 0, 5, 0, 5};
        byte[] otherWidth = {2, 2, 0, 9, (byte) 136, 5, 0, 5, 0, 5, 0, 5, 0, 5, 0, 5};
        byte[] oldFirst = {1, 1, 1, 8, 0, 5, 0, 5, 0, 5, 0, 5, 0, 5, 0, 5};
        byte[] oldLong = {5, 5, 5, 5, 1, 1, 1, 8, 0, 5, 0, 5};
        assertThatThrownBy(() -> read(joined(start, zero))).hasMessage("zero-length run in scanline");
        assertThatThrownBy(() -> read(joined(start, long8)))
                .hasMessage("a run of 9 texels where 8 are left in its scanline of 8");
        assertThatThrownBy(() -> read(joined(start, otherWidth)))
                .hasMessage("a scanline of 9 texels where the resolution line says 8");
        assertThatThrownBy(() -> read(joined(start, oldFirst))).hasMessageStartingWith("a run at the start");
        assertThatThrownBy(() -> read(joined(start, oldLong)))
                .hasMessage("a run of 8 texels where 7 are left in its scanline of 8");
    }

    private static byte[] joined(String text, byte[] rest) {
        ByteArrayOutputStream all = new ByteArrayOutputStream();
        all.writeBytes(ascii(text));
        all.writeBytes(rest);
        return all.toByteArray();
    }

    private static Skybox read(byte[] file) throws IOException {
        return SkyBytes.read(file);
    }

    /** Texels with runs of every length, one of them black; none looks like a run-length code. */
    private static byte[] texels(int width, int height) {
        Random random = new Random(7);
        byte[] texels = new byte[4 * width * height];
        byte[] texel = new byte[4];
        for (int at = 0; at < texels.length; at += 4) {
            if (at == 0 || (at / 4 >= width && random.nextInt(3) == 0)) {
                random.nextBytes(texel);
                texel[0] |= (byte) 0x80;
                texel[3] = random.nextInt(5) == 0 ? 0 : (byte) (100 + random.nextInt(60));
            }
            System.arraycopy(texel, 0, texels, at, 4);
        }
        return texels;
    }

    private static float[] expected(byte[] texels, double red, double green, double blue) {
        double[] divisors = {red, green, blue};
        float[] radiance = new float[texels.length / 4 * 3];
        for (int i = 0; i < radiance.length; i++) {
            int exponent = Byte.toUnsignedInt(texels[i / 3 * 4 + 3]);
            double mantissa = Byte.toUnsignedInt(texels[i / 3 * 4 + i % 3]);
            radiance[i] = exponent == 0 ? 0 : (float) (mantissa * Math.pow(2, exponent - 136) / divisors[i % 3]);
        }
        return radiance;
    }
}
