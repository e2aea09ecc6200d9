package dev.twister.sky.image;

import static org.assertj.core.api.Assertions.assertThat;

import dev.twister.sky.ExifBytes;
import java.util.Arrays;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class ExifOrientationTest {
    @ParameterizedTest
    @ValueSource(booleans = {false, true})
    void readsBothByteOrders(boolean littleEndian) {
        for (int orientation = 1; orientation <= 8; orientation++) {
            assertThat(ExifOrientation.of(ExifBytes.tiff(littleEndian, orientation)))
                    .isEqualTo(orientation);
        }
    }

    @Test
    void whatMakesNoSenseIsUpright() {
        assertThat(ExifOrientation.of(ExifBytes.tiff(true, 0))).isOne();
        assertThat(ExifOrientation.of(ExifBytes.tiff(true, 9))).isOne();
        byte[] whole = ExifBytes.tiff(false, 3);
        for (int length = 0; length < whole.length; length++) {
            assertThat(ExifOrientation.of(Arrays.copyOf(whole, length))).isIn(1, 3);
        }
        whole[4] = (byte) 0xff;
        assertThat(ExifOrientation.of(whole)).isOne();
    }

    /** Positions of the stored rows "abc" and "def" in the upright picture, in row-major order. */
    @ParameterizedTest
    @CsvSource({"1, abcdef", "2, cbafed", "3, fedcba", "4, defabc", "5, adbecf", "6, daebfc", "7, fcebda", "8, cfbead"})
    void turnsTexels(int orientation, String upright) {
        ScanOrder order = ScanOrder.ofExif(orientation, 3, 2);
        char[] turned = new char[6];
        for (int row = 0; row < 2; row++) {
            for (int column = 0; column < 3; column++) {
                turned[order.texel(row, column)] = "abcdef".charAt(3 * row + column);
            }
        }
        assertThat(order.width()).isEqualTo(orientation < 5 ? 3 : 2);
        assertThat(new String(turned)).isEqualTo(upright);
    }
}
