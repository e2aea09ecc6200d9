package dev.twister.gui.drawing;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;

class PreviewTest {
    @Test
    void aSlowPictureIsPrecededByOneAsSmallAsItTakes() {
        assertThat(Preview.divisor(0, false)).isEqualTo(1);
        assertThat(Preview.divisor(TimeUnit.MILLISECONDS.toNanos(150), false)).isEqualTo(1);
        assertThat(Preview.divisor(TimeUnit.MILLISECONDS.toNanos(200), false)).isEqualTo(2);
        assertThat(Preview.divisor(TimeUnit.MILLISECONDS.toNanos(900), false)).isEqualTo(4);
        assertThat(Preview.divisor(TimeUnit.MINUTES.toNanos(1), false)).isEqualTo(8);
        assertThat(Preview.divisor(TimeUnit.MINUTES.toNanos(1), true)).isEqualTo(16);
    }
}
