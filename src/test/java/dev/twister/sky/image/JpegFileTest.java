package dev.twister.sky.image;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import dev.twister.sky.ExifBytes;
import dev.twister.sky.JpegBytes;
import dev.twister.sky.Skybox;
import java.awt.color.ColorSpace;
import java.awt.color.ICC_Profile;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Base64;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class JpegFileTest {
    /** 16 x 16 red texels in inverted inks, as Adobe's programs write them. */
    private static final String CMYK =
            "/9j/7gAOQWRvYmUAZAAAAAAA/9sAQwAIBgYHBgUIBwcHCQkICgwUDQwLCwwZEhMPFB0aHx4dGhwcICQu"
                    + "JyAiLCMcHCg3KSwwMTQ0NB8nOT04MjwuMzQy/8AAFAgAEAAQBEMRAE0RAFkRAEsRAP/EAB8AAAEFAQEB"
                    + "AQEBAAAAAAAAAAABAgMEBQYHCAkKC//EALUQAAIBAwMCBAMFBQQEAAABfQECAwAEEQUSITFBBhNRYQci"
                    + "cRQygZGhCCNCscEVUtHwJDNicoIJChYXGBkaJSYnKCkqNDU2Nzg5OkNERUZHSElKU1RVVldYWVpjZGVm"
                    + "Z2hpanN0dXZ3eHl6g4SFhoeIiYqSk5SVlpeYmZqio6Slpqeoqaqys7S1tre4ubrCw8TFxsfIycrS09TV"
                    + "1tfY2drh4uPk5ebn6Onq8fLz9PX29/j5+v/aAA4EQwBNAFkASwAAPwD3+vn+vn+vf6KKKKKKKKKKKK//"
                    + "2Q==";

    private static final float AS_SRGB = 0.2462f;
    private static final float AS_LINEAR = 136 / 255f;

    /** Precision of an 8-bit JPEG sample, or of the sRGB that its decoder converts to. */
    private static final float EXACT = 0.01f;

    private static final byte[] LINEAR_RGB =
            ICC_Profile.getInstance(ColorSpace.CS_LINEAR_RGB).getData();
    private static final byte[] LINEAR_GRAY =
            ICC_Profile.getInstance(ColorSpace.CS_GRAY).getData();
    private static final byte[] RGB = JpegBytes.of(JpegBytes.image(16, 8, BufferedImage.TYPE_INT_RGB, 0x888888), false);
    private static final byte[] GRAY = JpegBytes.of(JpegBytes.image(16, 8, BufferedImage.TYPE_BYTE_GRAY, 0x88), false);

    private final List<String> warnings = new ArrayList<>();

    @Test
    void takesTheProfile() throws IOException {
        assertThat(red(RGB)).isCloseTo(AS_SRGB, within(EXACT));
        assertThat(red(JpegBytes.withProfile(RGB, 1, 1, LINEAR_RGB))).isCloseTo(AS_LINEAR, within(EXACT));
        assertThat(red(JpegBytes.withProfile(GRAY, 1, 1, LINEAR_GRAY))).isCloseTo(AS_LINEAR, within(EXACT));
        assertThat(warnings).isEmpty();
    }

    @Test
    void putsPiecesOfTheProfileTogetherInAnyOrder() throws IOException {
        byte[] first = Arrays.copyOf(LINEAR_RGB, 100);
        byte[] second = Arrays.copyOfRange(LINEAR_RGB, 100, LINEAR_RGB.length);
        byte[] inOrder = JpegBytes.withProfile(JpegBytes.withProfile(RGB, 2, 2, second), 1, 2, first);
        byte[] swapped = JpegBytes.withProfile(JpegBytes.withProfile(RGB, 1, 2, first), 2, 2, second);
        byte[] fromZero = JpegBytes.withProfile(JpegBytes.withProfile(RGB, 1, 2, second), 0, 2, first);
        for (byte[] file : List.of(inOrder, swapped, fromZero)) {
            assertThat(red(file)).isCloseTo(AS_LINEAR, within(EXACT));
        }
        assertThat(warnings).isEmpty();
    }

    @Test
    void readsBrokenProfilesAsSrgbWithAWarning() throws IOException {
        byte[] once = JpegBytes.withProfile(RGB, 1, 1, LINEAR_RGB);
        byte[] truncated = Arrays.copyOf(LINEAR_RGB, LINEAR_RGB.length / 2);
        List<byte[]> broken = List.of(
                JpegBytes.withProfile(once, 1, 1, LINEAR_RGB),
                JpegBytes.withProfile(RGB, 1, 2, LINEAR_RGB),
                JpegBytes.withProfile(RGB, 2, 2, LINEAR_RGB),
                JpegBytes.withProfile(RGB, 2, 1, LINEAR_RGB),
                JpegBytes.withProfile(RGB, 1, 0, LINEAR_RGB),
                JpegBytes.withProfile(JpegBytes.withProfile(RGB, 1, 2, LINEAR_RGB), 2, 3, new byte[380]),
                JpegBytes.withProfile(RGB, 1, 1, truncated),
                JpegBytes.withProfile(RGB, 1, 1, new byte[0]),
                JpegBytes.withProfile(RGB, 1, 1, new byte[500]),
                JpegBytes.withProfile(GRAY, 1, 1, truncated));
        for (byte[] file : broken) {
            warnings.clear();
            assertThat(red(file)).isCloseTo(AS_SRGB, within(EXACT));
            assertThat(warnings)
                    .singleElement()
                    .asString()
                    .matches("its color profile is (damaged|empty) and is ignored");
        }
    }

    @Test
    void readsForeignProfilesAsSrgbWithAWarning() throws IOException {
        byte[] link = LINEAR_RGB.clone();
        System.arraycopy(JpegBytes.ascii("link"), 0, link, 12, 4);
        List<byte[]> foreign = List.of(
                JpegBytes.withProfile(RGB, 1, 1, LINEAR_GRAY),
                JpegBytes.withProfile(GRAY, 1, 1, LINEAR_RGB),
                JpegBytes.withProfile(
                        RGB, 1, 1, ICC_Profile.getInstance(ColorSpace.CS_CIEXYZ).getData()),
                JpegBytes.withProfile(RGB, 1, 1, link));
        for (byte[] file : foreign) {
            warnings.clear();
            assertThat(red(file)).isCloseTo(AS_SRGB, within(EXACT));
            assertThat(warnings).containsExactly("its color profile is for another kind of image and is ignored");
        }
    }

    @ParameterizedTest
    @ValueSource(booleans = {false, true})
    void needsNoEndMarkerWhereAllElseIsThere(boolean progressive) throws IOException {
        byte[] whole = JpegBytes.of(gradient(), progressive);
        float[] expected = SkyBytes.read(whole).radiance();
        for (int missing = 1; missing <= 2; missing++) {
            byte[] file = Arrays.copyOf(whole, whole.length - missing);
            assertThat(SkyBytes.read(file).radiance()).isEqualTo(expected);
        }
        for (int length : new int[] {whole.length - 4, whole.length - 20, whole.length / 2}) {
            byte[] truncated = Arrays.copyOf(whole, length);
            assertThatThrownBy(() -> SkyBytes.read(truncated)).hasMessage("the JPEG ends before its last texel");
        }
    }

    @Test
    void refusesAProgressiveFileThatEndsBetweenTwoScans() {
        byte[] whole = JpegBytes.of(gradient(), true);
        int lastScan = whole.length;
        do {
            lastScan--;
        } while (whole[lastScan] != (byte) 0xff || whole[lastScan + 1] != (byte) 0xda);
        // Its Huffman table comes before the last scan.
        byte[] truncated = Arrays.copyOf(whole, lastScan);
        assertThatThrownBy(() -> SkyBytes.read(truncated)).hasMessage("the JPEG ends before its last texel");
    }

    @Test
    void refusesManyScansOfALargePicture() throws IOException {
        int scans = 40;
        byte[] file = progressive(16_384, 8192, scans);
        assertThatThrownBy(() -> SkyBytes.read(file))
                .hasMessage("a JPEG of 134217728 texels in 40 scans; at most 32 scans of such a size are read");
        assertThat(SkyBytes.read(progressive(64, 32, scans)).width()).isEqualTo(64);
    }

    @Test
    void turnsAsItsExifDataSay() throws IOException {
        BufferedImage image = JpegBytes.image(32, 16, BufferedImage.TYPE_INT_RGB, 0);
        image.getGraphics().fillRect(0, 0, 16, 16);
        byte[] stored = JpegBytes.of(image, false);
        Skybox upright = SkyBytes.read(JpegBytes.withExif(stored, ExifBytes.tiff(true, 1)));
        Skybox turned = SkyBytes.read(JpegBytes.withExif(stored, ExifBytes.tiff(false, 3)));
        Skybox onItsSide = SkyBytes.read(JpegBytes.withExif(stored, ExifBytes.tiff(true, 6)));
        assertThat(upright.radiance()[0]).isOne();
        assertThat(turned.radiance()[0]).isZero();
        assertThat(turned.radiance()[3 * 32 * 16 - 1]).isOne();
        assertThat(onItsSide.width()).isEqualTo(16);
        assertThat(onItsSide.radiance()[0]).isOne();
        assertThat(onItsSide.radiance()[3 * 16 * 31]).isZero();
    }

    @Test
    void aHighPictureThatIsTurnedMayBeAsWideAsAny() throws IOException {
        byte[] high = JpegBytes.of(JpegBytes.image(8, 8200, BufferedImage.TYPE_BYTE_GRAY, 0), false);
        assertThatThrownBy(() -> SkyBytes.read(high)).hasMessage("8 x 8200 texels; 1 x 1 to 16384 x 8192 are allowed");
        assertThat(SkyBytes.read(JpegBytes.withExif(high, ExifBytes.tiff(true, 8)))
                        .width())
                .isEqualTo(8200);
    }

    @ParameterizedTest
    @ValueSource(ints = {0, 2, 3})
    void takesJfifBeforeAnAdobeSegmentThatContradictsIt(int transform) throws IOException {
        byte[] adobe = JpegBytes.joined(JpegBytes.ascii("Adobe"), new byte[] {0, 100, 0, 0, 0, 0, (byte) transform});
        assertThat(SkyBytes.read(JpegBytes.with(RGB, 0xee, adobe)).radiance())
                .isEqualTo(SkyBytes.read(RGB).radiance());
    }

    @Test
    void readsCmyk() throws IOException {
        Skybox red = SkyBytes.read(Base64.getDecoder().decode(CMYK), warnings);

        assertThat(red.radiance()).startsWith(1, 0, 0).endsWith(1, 0, 0);
        assertThat(warnings).singleElement().asString().contains("a CMYK image");
    }

    private float red(byte[] file) throws IOException {
        return SkyBytes.read(file, warnings).radiance()[0];
    }

    private static BufferedImage gradient() {
        BufferedImage image = new BufferedImage(64, 32, BufferedImage.TYPE_INT_RGB);
        for (int i = 0; i < 2048; i++) {
            image.setRGB(i % 64, i / 64, i * 0x020509);
        }
        return image;
    }

    /** A gray picture with this number of empty scans, each with two zero coefficients. */
    private static byte[] progressive(int width, int height, int scans) {
        byte[] file = {(byte) 0xff, (byte) 0xd8};
        byte[] table = new byte[65];
        Arrays.fill(table, 1, 65, (byte) 1);
        file = segment(file, 0xdb, table);
        file = segment(file, 0xc2, 8, height >> 8, height, width >> 8, width, 1, 1, 0x11, 0);
        file = segment(file, 0xc4, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0);
        file = segment(file, 0xda, 1, 1, 0, 0, 0, 1);
        byte[] blocks = new byte[Math.ceilDiv(width, 8) * Math.ceilDiv(height, 8) / 8];
        file = JpegBytes.joined(file, blocks);
        for (int scan = 1; scan < scans; scan++) {
            file = segment(file, 0xda, 1, 1, 0, 0, 0, 0x10);
            file = JpegBytes.joined(file, blocks);
        }
        return JpegBytes.joined(file, new byte[] {(byte) 0xff, (byte) 0xd9});
    }

    private static byte[] segment(byte[] file, int marker, int... payload) {
        byte[] bytes = new byte[payload.length];
        for (int i = 0; i < payload.length; i++) {
            bytes[i] = (byte) payload[i];
        }
        return segment(file, marker, bytes);
    }

    private static byte[] segment(byte[] file, int marker, byte[] payload) {
        byte[] head = {(byte) 0xff, (byte) marker, (byte) ((payload.length + 2) >> 8), (byte) (payload.length + 2)};
        return JpegBytes.joined(JpegBytes.joined(file, head), payload);
    }
}
