package dev.twister.gui.viewer;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import dev.twister.gui.viewer.ComparedPictures.Mode;
import dev.twister.scene.Rendering;
import org.junit.jupiter.api.Test;

/** Two pixels beside each other: white and black against black and black. */
class ComparedPicturesTest {
    private static final int WHITE = 0xFFFFFFFF;
    private static final int BLACK = 0xFF000000;
    private static final ComparedPictures PICTURES =
            new ComparedPictures(2, 1, new float[] {1, 1, 1, 0, 0, 0}, new float[6]);

    @Test
    void eachIsShownAlone() {
        assertThat(pixels(Mode.FIRST, 0)).containsExactly(WHITE, BLACK);
        assertThat(pixels(Mode.SECOND, 0)).containsExactly(BLACK, BLACK);
    }

    @Test
    void sideBySideTheyAreTwiceAsWide() {
        assertThat(PICTURES.width(Mode.SIDE_BY_SIDE)).isEqualTo(4);
        assertThat(pixels(Mode.SIDE_BY_SIDE, 0)).containsExactly(WHITE, BLACK, BLACK, BLACK);
    }

    @Test
    void aWipeShowsTheFirstAtTheLeft() {
        assertThat(pixels(Mode.WIPE, 1)).containsExactly(WHITE, BLACK);
        assertThat(pixels(Mode.WIPE, -5)).containsExactly(BLACK, BLACK);
    }

    @Test
    void theDifferenceIsThatOfTheRadiance() {
        assertThat(pixels(Mode.DIFFERENCE, 0)).containsExactly(WHITE, BLACK);
        assertThat(PICTURES.rootMeanSquare()).isEqualTo(Math.sqrt(0.5), within(1e-9));
    }

    private static int[] pixels(Mode mode, int wiped) {
        return PICTURES.pixels(mode, wiped, Rendering.DEFAULT);
    }
}
