package dev.twister.kernel;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** A texture of two texels, one above the other. */
class TextureTest {
    private static final float[] TEXELS = {1, 1, 1, 0.5f, 0.5f, 0.5f};

    @ParameterizedTest
    @CsvSource({"1, 1", "-1, 0.5"})
    void rowsOfASphereEndAtThePoles(float up, float expected) {
        assertThat(texel(Layout.FIRST_SPHERE, new float[] {0, up, 0})).isEqualTo(expected);
    }

    @Test
    void rowsOfThePlaneRepeat() {
        assertThat(texel(Layout.PLANE, new float[] {0, 1, 0})).isEqualTo(0.75f);
    }

    @Test
    void aPackedTexelHasACodePerChannel() {
        float[] images = new float[Layout.CODES + 2];
        images[17] = 0.25f;
        images[255] = 0.75f;
        images[Layout.CODES + 1] = 17 + 256 * 255;

        assertThat(Texture.texel(Layout.CODES, 1, 1, 0, images)).isEqualTo(0.25f);
        assertThat(Texture.texel(Layout.CODES, 1, 1, 1, images)).isEqualTo(0.75f);
        assertThat(Texture.texel(Layout.CODES, 1, 1, 2, images)).isZero();
    }

    /** With {@link Texture#REPEAT}, {@link Texture#CLAMP} and {@link Texture#MIRROR}. */
    @ParameterizedTest
    @CsvSource({
        "0.25, 0, 0, 0.5",
        "1.25, 0, 0, 0.5",
        "1.25, 1, 0, 3",
        "-0.25, 1, 0, 0",
        "1.25, 2, 0, 2.5",
        "-0.25, 2, 0, 0.5",
        "0.3, 0, 1, 1",
        "0.999, 0, 1, 3",
        "1.2, 2, 1, 3"
    })
    void placesBeyondTheBorders(float coordinate, int wrap, int nearest, float expected) {
        assertThat(Texture.place(coordinate, 4, wrap, nearest)).isEqualTo(expected, within(1e-5f));
    }

    private static float texel(int body, float[] normal) {
        float[] path = new float[Layout.PATH_LENGTH];
        System.arraycopy(normal, 0, path, Layout.NORMAL, 3);
        float[] looks = new float[Layout.MAPS_STRIDE];
        looks[Layout.MAP_WIDTH] = 1;
        looks[Layout.MAP_HEIGHT] = 2;
        Texture.aim(path, 0, body, new float[Layout.DISC], looks, Variant.MATERIALS);
        return Texture.channel(path, 0, 0, looks, TEXELS);
    }
}
