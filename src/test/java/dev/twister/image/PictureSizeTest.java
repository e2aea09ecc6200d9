package dev.twister.image;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class PictureSizeTest {
    @ParameterizedTest
    @CsvSource({
        "720p, 1280, 720",
        "1080P, 1920, 1080",
        "4k, 3840, 2160",
        "4K, 3840, 2160",
        "1x1, 1, 1",
        "16384X16384, 16384, 16384",
        "17x3, 17, 3"
    })
    void reads(String text, int width, int height) {
        assertThat(PictureSize.parse(text)).isEqualTo(new PictureSize(width, height));
    }

    @ParameterizedTest
    @ValueSource(strings = {"", "x", "10", "10x", "x10", "0x1", "1x0", "-1x5", "9999999999x1", "1.5x2", "8k"})
    void refuses(String text) {
        assertThatIllegalArgumentException().isThrownBy(() -> PictureSize.parse(text));
    }
}
