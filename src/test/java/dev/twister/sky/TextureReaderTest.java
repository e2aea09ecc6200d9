package dev.twister.sky;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.awt.image.BufferedImage;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Path;
import java.util.Base64;
import java.util.List;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Test;

class TextureReaderTest {
    @Test
    void eightBitsStayEightBits() throws IOException {
        BufferedImage image = new BufferedImage(2, 1, BufferedImage.TYPE_INT_ARGB);
        image.setRGB(0, 0, 0xff804020);
        image.setRGB(1, 0, 0x05ffffff);

        PackedImage texture = (PackedImage) read(image);

        assertThat(texture.texels()).containsExactly(0xff204080, 0x05ffffff);
        assertThat(texture.isOpaque()).isFalse();
        assertThat(texture.linear()).isEqualTo(CurveEncoding.SRGB.table(255));
    }

    @Test
    void sixteenBitsBecomeFloats() throws IOException {
        BufferedImage image = new BufferedImage(1, 1, BufferedImage.TYPE_USHORT_GRAY);
        image.getRaster().setSample(0, 0, 0, 257);

        assertThat(((Skybox) read(image)).radiance()[0])
                .isEqualTo(CurveEncoding.SRGB.table(65_535)[257]);
    }

    @Test
    void readsWebp() {
        byte[] red = Base64.getDecoder()
                .decode(
                        "UklGRlgAAABXRUJQVlA4IEwAAABQAgCdASoIAAgAAUAmJbACdLoB+ACJVQVkbUAA/v6VT/8oP//lxzL/7cYNP2X7FSGHz1Zf"
                                + "/eUP981865/9F3j/hthvy0L5aF/yTgAA");

        PackedImage texture = (PackedImage) TextureReader.read(Path.of("red.webp"), red, _ -> {});

        assertThat(texture.width()).isEqualTo(8);
        assertThat(texture.value(7, 0)).isGreaterThan(220);
        assertThat(texture.value(7, 1)).isLessThan(10);
    }

    @Test
    void keepsTheAlphaAndTheClearColorsOfWebp() throws IOException {
        for (String name : List.of("plain-alpha", "prediction")) {
            byte[] webp = resource("/webp/" + name + ".webp");

            PackedImage texture = (PackedImage) TextureReader.read(Path.of(name), webp, _ -> {});

            PackedImage png =
                    (PackedImage) TextureReader.read(Path.of(name), resource("/webp/" + name + ".png"), _ -> {});
            assertThat(texture.isOpaque()).isFalse();
            assertThat(texture.texels()).isEqualTo(png.texels());
        }
    }

    @Test
    void refusesMoreTexelsThanFewBytesMayHave() {
        byte[] wide = Base64.getDecoder().decode("UklGRh4AAABXRUJQVlA4TBEAAAAv/r//BwdQ5CrUo/+BiOh/AAA=");

        assertThatThrownBy(() -> TextureReader.read(Path.of("wide.webp"), wide, _ -> {}))
                .hasMessageStartingWith("wide.webp: ")
                .hasMessageContaining("texels");
    }

    private static byte[] resource(String name) throws IOException {
        try (InputStream file = TextureReaderTest.class.getResourceAsStream(name)) {
            return file.readAllBytes();
        }
    }

    @Test
    void refusesDamagedWebp() {
        byte[] damaged = Base64.getDecoder().decode("UklGRlgAAABXRUJQVlA4IEwAAABQAgCdASoIAAgA");

        assertThatThrownBy(() -> TextureReader.read(Path.of("red.webp"), damaged, _ -> {}))
                .isInstanceOf(SkyException.class)
                .hasMessageStartingWith("red.webp: ");
    }

    private static TextureImage read(BufferedImage image) throws IOException {
        ByteArrayOutputStream file = new ByteArrayOutputStream();
        ImageIO.write(image, "png", file);
        return TextureReader.read(Path.of("image.png"), file.toByteArray(), _ -> {});
    }
}
