package dev.twister.kernel;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** A texture of two texels, one above the other. */
class TextureTest {
    private static final float[] TEXELS = {1, 1, 1, 0.5f, 0.5f, 0.5f};

    @ParameterizedTest
    @CsvSource({"1, 1", "-1, 0.5"})
    void rowsOfASphereEndAtThePoles(float up, float expected) {
        assertThat(albedo(Layout.FIRST_SPHERE, new float[] {0, up, 0})).isEqualTo(expected);
    }

    @Test
    void rowsOfThePlaneRepeat() {
        assertThat(albedo(Layout.PLANE, new float[] {0, 1, 0})).isEqualTo(0.75f);
    }

    private static float albedo(int body, float[] normal) {
        float[] path = new float[Layout.PATH_LENGTH];
        System.arraycopy(normal, 0, path, Layout.NORMAL, 3);
        Arrays.fill(path, Layout.ALBEDO, Layout.ALBEDO + 3, 1f);
        float[] looks = new float[Layout.TEXTURE_STRIDE];
        looks[Layout.TEXTURE_WIDTH] = 1;
        looks[Layout.TEXTURE_HEIGHT] = 2;
        Texture.multiply(path, body, 1, new float[Layout.DISC], looks, TEXELS, Variant.MATERIALS);
        return path[Layout.ALBEDO];
    }
}
