package dev.twister.gui.drawing;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;

class QuickAnswerTest {
    @Test
    void aSlowPictureIsPrecededByOneAsSmallAsItTakes() {
        assertThat(QuickAnswer.divisor(0)).isEqualTo(1);
        assertThat(QuickAnswer.divisor(TimeUnit.MILLISECONDS.toNanos(150))).isEqualTo(1);
        assertThat(QuickAnswer.divisor(TimeUnit.MILLISECONDS.toNanos(200))).isEqualTo(2);
        assertThat(QuickAnswer.divisor(TimeUnit.MILLISECONDS.toNanos(900))).isEqualTo(4);
        assertThat(QuickAnswer.divisor(TimeUnit.MINUTES.toNanos(1))).isEqualTo(8);
    }
}
