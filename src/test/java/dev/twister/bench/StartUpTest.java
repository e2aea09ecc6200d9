package dev.twister.bench;

import static org.assertj.core.api.Assertions.assertThat;

import dev.twister.engine.Engine;
import dev.twister.image.Frame;
import dev.twister.image.FrameTimes;
import dev.twister.world.FrameInput;
import dev.twister.world.SampleWorld;
import java.time.Duration;
import org.junit.jupiter.api.Test;

class StartUpTest {
    private static final long MILLI = 1_000_000;

    private long now = 400 * MILLI;
    private int drawn;
    private int slowFrom = Integer.MAX_VALUE;

    @Test
    void tellsTheFirstFrameAndWhenNineTenthsOfTheSpeedAreReached() {
        StartUpReport report = start(5);

        assertThat(report.firstFrame()).isEqualTo(Duration.ofMillis(400 + 100));
        assertThat(report.fullFrame()).isEqualTo(Duration.ofMillis(10));
        assertThat(report.fullSpeed()).isEqualTo(Duration.ofMillis(400 + 20 * 100 + 10));
        assertThat(report.firstEngine()).isEqualTo("slow");
        assertThat(report.lastEngine()).isEqualTo("fast");
    }

    @Test
    void oneFrameIsDrawnHoweverShortTheTime() {
        StartUpReport report = start(0);

        assertThat(report.frames()).isOne();
        assertThat(report.fullSpeed()).isEqualTo(report.firstFrame());
    }

    @Test
    void whatSlowsTheFramesDownLaterIsNoFullSpeed() {
        slowFrom = 200;

        StartUpReport report = start(8);

        assertThat(report.fullFrame()).isEqualTo(Duration.ofMillis(10));
        assertThat(report.fullSpeed()).isEqualTo(Duration.ofMillis(400 + 20 * 100 + 10));
    }

    private StartUpReport start(int seconds) {
        return new StartUp(() -> now)
                .run(WarmingEngine::new, SampleWorld.ofSize(8, 8).snapshot(), Duration.ofSeconds(seconds), () -> {});
    }

    /** Takes 100 ms for each of 20 frames, then 10, and 20 where it is slow again. */
    private final class WarmingEngine implements Engine {
        @Override
        public String id() {
            return drawn <= 20 ? "slow" : "fast";
        }

        @Override
        public String device() {
            return "a device of the test's";
        }

        @Override
        public void render(FrameInput input, Frame frame) {
            drawn++;
            long nanos = (drawn <= 20 ? 100 : drawn < slowFrom ? 10 : 20) * MILLI;
            now += nanos;
            frame.setTimes(FrameTimes.onJvm(nanos));
        }

        @Override
        public void close() {
            // Holds nothing.
        }
    }
}
