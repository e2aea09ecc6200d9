package dev.twister.engine;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import org.junit.jupiter.api.Test;

class BestTimeTest {
    private static final long MILLI = 1_000_000;

    private final BestTime best = new BestTime();

    @Test
    void withoutAFrameThereIsNone() {
        assertThat(best.found()).isEmpty();
        assertThat(best.isSettled()).isFalse();
    }

    @Test
    void isTheFastest() {
        add(40, 1);
        add(20, 1);
        add(30, 1);

        assertThat(best.found()).contains(Duration.ofMillis(20));
    }

    @Test
    void settlesOverTimeAndFrames() {
        add(10, 1);
        add(10, 69);
        assertThat(best.isSettled()).isFalse();

        add(10, 1);
        assertThat(best.isSettled()).isTrue();
    }

    @Test
    void aFewSlowFramesAreNotEnough() {
        add(1000, 20);

        assertThat(best.isSettled()).isFalse();
    }

    @Test
    void aBetterFrameStartsAnew() {
        add(10, 71);
        add(9, 1);

        assertThat(best.isSettled()).isFalse();
    }

    @Test
    void aCompilersWorkStartsAnew() {
        add(10, 71);
        best.add(10 * MILLI, true);

        assertThat(best.isSettled()).isFalse();
    }

    @Test
    void whatIsForgottenIsGone() {
        add(10, 100);
        best.forget();

        assertThat(best.found()).isEmpty();
        assertThat(best.isSettled()).isFalse();
    }

    private void add(int millis, int frames) {
        for (int i = 0; i < frames; i++) {
            best.add(millis * MILLI, false);
        }
    }
}
