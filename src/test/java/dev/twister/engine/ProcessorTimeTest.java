package dev.twister.engine;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import dev.twister.engine.vector.VectorEngines;
import dev.twister.image.Frame;
import dev.twister.image.FrameTimes;
import dev.twister.world.FrameInput;
import dev.twister.world.SampleWorld;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class ProcessorTimeTest {
    @ParameterizedTest
    @ValueSource(strings = {JvmEngines.SEQUENTIAL, JvmEngines.PARALLEL, VectorEngines.VECTOR})
    void enginesOfTheJvmTellTheirThreadsTime(String engine) {
        assumeTrue(ProcessorTime.ofThisThread() > 0, "this system does not tell it");
        FrameInput input = SampleWorld.ofSize(64, 64).snapshot();
        Frame frame = Frame.ofPixels(64, 64);
        try (Engine opened = Engines.open(engine)) {
            opened.render(input, frame);
        }

        assertThat(frame.times().processorNanos()).isPositive();
    }

    @Test
    void timesThatAreKnownAreSummed() {
        FrameTimes one = FrameTimes.onJvm(10, 4);

        assertThat(one.plus(one)).isEqualTo(FrameTimes.onJvm(20, 8));
    }

    @Test
    void anUnknownTimeIsThatOfTheClock() {
        assertThat(FrameTimes.onJvm(10).effortNanos()).isEqualTo(10);
        int cores = Runtime.getRuntime().availableProcessors();
        assertThat(FrameTimes.onJvm(10, 4L * cores).effortNanos()).isEqualTo(4);
    }
}
