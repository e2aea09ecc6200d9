package dev.twister.gui.drawing;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;

class QuickAnswerTest {
    @Test
    void aSlowPictureIsPrecededByOneAsSmallAsItTakes() {
        assertThat(QuickAnswer.divisor(0, QuickAnswer.MOST)).isEqualTo(1);
        assertThat(QuickAnswer.divisor(TimeUnit.MILLISECONDS.toNanos(150), QuickAnswer.MOST))
                .isEqualTo(1);
        assertThat(QuickAnswer.divisor(TimeUnit.MILLISECONDS.toNanos(200), QuickAnswer.MOST))
                .isEqualTo(2);
        assertThat(QuickAnswer.divisor(TimeUnit.MILLISECONDS.toNanos(900), QuickAnswer.MOST))
                .isEqualTo(4);
        assertThat(QuickAnswer.divisor(TimeUnit.MINUTES.toNanos(1), QuickAnswer.MOST))
                .isEqualTo(8);
        assertThat(QuickAnswer.divisor(TimeUnit.MINUTES.toNanos(1), QuickAnswer.MOST_TRACED))
                .isEqualTo(16);
    }
}
