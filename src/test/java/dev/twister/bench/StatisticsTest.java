package dev.twister.bench;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.stream.LongStream;
import org.junit.jupiter.api.Test;

class StatisticsTest {
    private static final long MILLI = 1_000_000;

    @Test
    void ofAnOddNumberOfFrames() {
        Statistics statistics = Statistics.ofNanos(30 * MILLI, 10 * MILLI, 80 * MILLI);

        assertThat(statistics).isEqualTo(new Statistics(3, 10, 30, 40, 80));
        assertThat(statistics.fps()).isEqualTo(25);
    }

    @Test
    void medianOfAnEvenNumberOfFramesIsBetweenTheMiddleTwo() {
        assertThat(Statistics.ofNanos(4 * MILLI, MILLI, 2 * MILLI, 3 * MILLI).median())
                .isEqualTo(2.5);
    }

    @Test
    void ninetyFifthPercentileIsTheNearestRank() {
        assertThat(Statistics.ofNanos(frames(20)).p95()).isEqualTo(19);
        assertThat(Statistics.ofNanos(frames(21)).p95()).isEqualTo(20);
        assertThat(Statistics.ofNanos(frames(100)).p95()).isEqualTo(95);
    }

    @Test
    void ofOneFrame() {
        assertThat(Statistics.ofNanos(1_500_000)).isEqualTo(new Statistics(1, 1.5, 1.5, 1.5, 1.5));
        assertThat(Statistics.ofNanos(1_500_000).fps()).isCloseTo(666.7, within(0.1));
    }

    @Test
    void ofNoneThereAreNone() {
        assertThatThrownBy(Statistics::ofNanos).isInstanceOf(IllegalArgumentException.class);
    }

    private static long[] frames(int count) {
        return LongStream.rangeClosed(1, count).map(millis -> millis * MILLI).toArray();
    }
}
