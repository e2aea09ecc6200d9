package dev.twister.gui.picture;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import org.junit.jupiter.api.Test;

class PictureDifferenceTest {
    private static final int[] ONE = {0xFF000000, 0xFF102030, 0xFF808080, 0xFFFFFFFF};
    private static final int[] OTHER = {0xFF000001, 0xFF102033, 0xFF858080, 0xFFFFFFFF};

    @Test
    void theLargestIsNamedWithItsPlace() {
        assertThat(PictureDifference.of(ONE, OTHER, 2)).isEqualTo(new PictureDifference(5, 0, 1, 2, 4));
        assertThat(PictureDifference.of(ONE, ONE, 2)).isEqualTo(new PictureDifference(0, 0, 0, 0, 4));
    }

    @Test
    void itsPictureIsSixteenTimesAsBright() {
        assertThat(PictureDifference.picture(ONE, OTHER))
                .containsExactly(0xFF000010, 0xFF000030, 0xFF500000, 0xFF000000);
    }

    @Test
    void picturesOfOtherSizesAreRefused() {
        assertThatThrownBy(() -> PictureDifference.of(ONE, new int[1], 1)).hasMessage("4 pixels compared with 1");
    }
}
