package dev.twister.engine.tornado;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class RoomTest {
    @ParameterizedTest
    @CsvSource({"1, 2097152", "2073600, 2097152", "8294400, 8388608", "33177600, 33554432", "40000000, 40000000"})
    void commonSizesHaveRoomInSteps(int pixels, int room) {
        assertThat(Room.ofPixels(pixels)).isEqualTo(room);
    }

    @Test
    void oneMoreBodyFits() {
        for (int floats : new int[] {0, 100, 10_000, 100_000_000}) {
            assertThat(Room.fits(Room.ofFloats(floats), floats + 100)).isTrue();
        }
        assertThat(Room.fits(100, 101)).isFalse();
    }

    @Test
    void farTooLargeBuffersDoNotFit() {
        assertThat(Room.fits(Room.ofFloats(1_000_000), 1000)).isFalse();
    }

    @Test
    void theLongestBufferIsAnArray() {
        assertThat(Room.ofFloats(Integer.MAX_VALUE - 8)).isEqualTo(Integer.MAX_VALUE - 8);
    }
}
