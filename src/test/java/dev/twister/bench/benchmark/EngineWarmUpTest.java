package dev.twister.bench.benchmark;

import static org.assertj.core.api.Assertions.assertThat;

import dev.twister.engine.Engine;
import dev.twister.image.Frame;
import dev.twister.image.FrameTimes;
import dev.twister.image.PictureSize;
import dev.twister.world.FrameInput;
import dev.twister.world.SampleWorld;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

class EngineWarmUpTest {
    private static final FrameInput WIDE = SampleWorld.ofSize(1280, 720).snapshot();
    private static final FrameInput TINY = SampleWorld.ofSize(9, 4).snapshot();

    private final List<PictureSize> drawn = new ArrayList<>();

    @Test
    void drawsSmallPicturesUntilTheyGetNoFaster() {
        warmUp("vector", 1000, List.of(WIDE));

        assertThat(drawn).hasSizeGreaterThan(CompiledLate.SLOW_FRAMES + 20).containsOnly(new PictureSize(320, 180));
    }

    @Test
    void drawsEachInputInTurn() {
        warmUp("vector", 1000, List.of(WIDE, TINY));

        assertThat(drawn).startsWith(new PictureSize(320, 180)).endsWith(new PictureSize(9, 4));
    }

    @Test
    void drawsOneOfEachWhereThereIsNoTime() {
        warmUp("vector", 0, List.of(WIDE, TINY));

        assertThat(drawn).containsExactly(new PictureSize(320, 180), new PictureSize(9, 4));
    }

    @Test
    void devicesTryWorkGroupsInTheMeasuredSizeFirst() {
        warmUp("tornado:0:0", 0, List.of(WIDE));

        assertThat(drawn.subList(0, 6)).containsOnly(new PictureSize(1280, 720));
        assertThat(drawn.subList(6, drawn.size())).containsExactly(new PictureSize(320, 180));
    }

    private void warmUp(String id, double seconds, List<FrameInput> inputs) {
        new Benchmark.EngineWarmUp(seconds, BenchmarkProgress.SILENT)
                .run(new Benchmark.AskedEngine(id, new CompiledLate(id, drawn)), new PictureSize(1280, 720), inputs);
    }

    /** Reports frame times that fall by a tenth from frame to frame until the engine counts as compiled. */
    private record CompiledLate(String id, List<PictureSize> drawn) implements Engine {
        private static final int SLOW_FRAMES = 40;
        private static final double FIRST_NANOS = 1e10;

        @Override
        public String device() {
            return "a device of the test's";
        }

        @Override
        public void render(FrameInput input, Frame frame) {
            double share = Math.pow(0.9, Math.min(SLOW_FRAMES, drawn.size()));
            drawn.add(new PictureSize(frame.width(), frame.height()));
            frame.setTimes(FrameTimes.onJvm((long) (FIRST_NANOS * share)));
        }

        @Override
        public void close() {
            // Nothing to release.
        }
    }
}
