package dev.twister.engine.vector;

import static org.assertj.core.api.Assertions.assertThat;

import dev.twister.engine.Engine;
import dev.twister.image.Frame;
import dev.twister.world.FrameInput;
import dev.twister.world.Positions;
import dev.twister.world.SampleWorld;
import dev.twister.world.World;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;

/** A picture is a function of its input alone, not of earlier frames, thread count or a concurrent rehearsal. */
class RepeatedFramesTest {
    private static final int ROOM = 400;
    private static final int CROWD = 100;
    private static final int ORDERS = 3;

    private final List<FrameInput> inputs = new ArrayList<>();

    RepeatedFramesTest() {
        for (int count = 2; count <= ROOM; count += 33) {
            inputs.add(poured(count, 203, 115));
            inputs.add(poured(count, 96, 54));
        }
        inputs.add(SampleWorld.ofSize(203, 115).snapshot());
        inputs.add(SampleWorld.ofSize(96, 54).snapshot());
    }

    @Test
    void framesAreTheSameInEveryOrderOnAnyNumberOfThreads() {
        List<int[]> alone = new ArrayList<>();
        for (FrameInput input : inputs) {
            try (Engine engine = VectorEngines.open(1, CROWD)) {
                alone.add(draw(engine, input));
            }
        }
        List<Integer> order = new ArrayList<>();
        for (int number = 0; number < inputs.size(); number++) {
            order.add(number);
        }
        Random random = new Random(1);
        for (int threads = 1; threads <= ORDERS; threads++) {
            Collections.shuffle(order, random);
            try (Engine engine = VectorEngines.open(threads, CROWD)) {
                for (int number : order) {
                    assertThat(draw(engine, inputs.get(number)))
                            .as("input %d with %d threads", number, threads)
                            .isEqualTo(alone.get(number));
                }
            }
        }
    }

    private static int[] draw(Engine engine, FrameInput input) {
        Frame frame = Frame.ofPixels(input.width(), input.rows());
        engine.render(input, frame);
        return frame.argb();
    }

    private static FrameInput poured(int count, int width, int height) {
        World world = SampleWorld.crowd(ROOM, width, height);
        world.setBodyPositions(Positions.of(world.snapshot()), count);
        return world.snapshot();
    }
}
