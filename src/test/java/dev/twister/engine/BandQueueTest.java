package dev.twister.engine;

import static org.assertj.core.api.Assertions.assertThat;

import dev.twister.engine.BandQueue.Band;
import org.junit.jupiter.api.Test;

class BandQueueTest {
    private final BandQueue queue = new BandQueue(100);

    @Test
    void bandsAreTakenFromBothEndsUntilNoneIsLeft() {
        assertThat(queue.takeFromTop(40)).contains(new Band(0, 40));
        assertThat(queue.takeFromBottom(0.5, 16)).contains(new Band(70, 30));
        assertThat(queue.takeFromBottom(0.5, 16)).contains(new Band(54, 16));
        assertThat(queue.takeFromTop(40)).contains(new Band(40, 14));
        assertThat(queue.takeFromTop(40)).isEmpty();
        assertThat(queue.takeFromBottom(1, 16)).isEmpty();
    }

    @Test
    void nothingIsLeftOnceItIsStopped() {
        queue.stop();
        assertThat(queue.takeFromTop(1)).isEmpty();
        assertThat(queue.takeFromBottom(1, 1)).isEmpty();
        assertThat(queue.rows()).isEqualTo(100);
    }
}
