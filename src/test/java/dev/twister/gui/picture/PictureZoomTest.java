package dev.twister.gui.picture;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import dev.twister.gui.picture.PictureZoom.Side;
import org.junit.jupiter.api.Test;

class PictureZoomTest {
    private static final Side ACROSS = new Side(200, 300);
    private static final Side DOWN = new Side(100, 100);

    @Test
    void aPictureThatFitsIsInTheMiddle() {
        assertThat(PictureZoom.FIT.left(ACROSS)).isEqualTo(50);
        assertThat(PictureZoom.FIT.top(DOWN)).isEqualTo(0);
    }

    @Test
    void whatIsUnderThePointerStaysThere() {
        PictureZoom zoom = PictureZoom.FIT.times(4, ACROSS, 150, DOWN, 30);

        assertThat(zoom.factor()).isEqualTo(4);
        assertThat((150 - zoom.left(ACROSS)) / (4 * 200)).isCloseTo(0.5, within(1e-9));
        assertThat((30 - zoom.top(DOWN)) / (4 * 100)).isCloseTo(0.3, within(1e-9));
        assertThat(zoom.times(0.25, ACROSS, 0, DOWN, 0)).isEqualTo(PictureZoom.FIT);
    }

    @Test
    void itMovesAsFarAsThereIsMoreOfIt() {
        PictureZoom zoom = PictureZoom.FIT.times(4, ACROSS, 150, DOWN, 50);

        assertThat(zoom.moved(ACROSS, 10, DOWN, -20).left(ACROSS)).isCloseTo(zoom.left(ACROSS) + 10, within(1e-9));
        assertThat(zoom.moved(ACROSS, 10, DOWN, -20).top(DOWN)).isCloseTo(zoom.top(DOWN) - 20, within(1e-9));
        assertThat(zoom.moved(ACROSS, 1e6, DOWN, -1e6).left(ACROSS)).isEqualTo(0);
        assertThat(zoom.moved(ACROSS, 1e6, DOWN, -1e6).top(DOWN)).isEqualTo(100 - 400);
    }
}
