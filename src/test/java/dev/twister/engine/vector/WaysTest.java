package dev.twister.engine.vector;

import static org.assertj.core.api.Assertions.assertThat;

import dev.twister.engine.Engine;
import dev.twister.engine.Engines;
import dev.twister.image.Frame;
import dev.twister.oracle.PictureDifference;
import dev.twister.world.FrameInput;
import dev.twister.world.SampleWorld;
import dev.twister.world.World;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

class WaysTest {
    private static final int CROWD = 20;
    private static final int ROOM = 10 * CROWD;

    /** More frames than an engine takes to be warm. */
    private static final int WARM = 100;

    private final List<FakeRehearsal> started = new ArrayList<>();
    private final Ways ways = new Ways(CROWD, this::start);

    @Test
    void aCrowdIsWalkedThrough() {
        assertThat(ways.walk(bodies(CROWD - 1))).isFalse();
        assertThat(ways.walk(bodies(CROWD))).isTrue();
        assertThat(ways.walk(bodies(CROWD - 1))).isFalse();
        assertThat(started).isEmpty();
    }

    @Test
    void whereACrowdIsToComeTheWalkIsRehearsedOnceTheEngineIsWarm() {
        ways.walk(bodies(5));
        assertThat(started).isEmpty();
        warm();
        assertThat(started).hasSize(1);
    }

    @Test
    void aCrowdThatComesBeforeTheRehearsalIsOverWaits() {
        warm();
        assertThat(ways.walk(bodies(CROWD))).isFalse();
        assertThat(ways.walk(bodies(CROWD + 1))).isFalse();

        started.getFirst().over = true;
        assertThat(ways.walk(bodies(CROWD + 1))).isTrue();
        assertThat(ways.walk(bodies(5))).isFalse();
        warm();
        assertThat(started).hasSize(1);
    }

    @Test
    void twiceACrowdWaitsForNothing() {
        warm();
        assertThat(ways.walk(bodies(2 * CROWD))).isTrue();
        assertThat(started).hasSize(1).allMatch(rehearsal -> rehearsal.closed);
        assertThat(ways.walk(bodies(CROWD))).isTrue();
    }

    @Test
    void nothingIsRehearsedForAFewThatStayAFew() {
        FrameInput few = SampleWorld.ofSize(4, 4).snapshot();
        for (int frame = 0; frame < WARM; frame++) {
            ways.walk(few);
        }
        assertThat(started).isEmpty();
    }

    @Test
    void nothingIsRehearsedThatWasDrawn() {
        ways.walk(bodies(CROWD));
        warm();
        assertThat(started).isEmpty();
    }

    @Test
    void closingEndsARehearsal() {
        warm();
        ways.close();
        assertThat(started).hasSize(1).allMatch(rehearsal -> rehearsal.closed);
    }

    @Test
    void bothWaysDrawTheSamePicture() {
        warm();
        try (Engine vector = new VectorEngine(2, ways);
                Engine sequential = Engines.open("sequential")) {
            assertSame(vector, sequential, bodies(CROWD + 10));
            started.getFirst().over = true;
            assertSame(vector, sequential, bodies(CROWD + 10));
        }
    }

    @Test
    @Timeout(60)
    void aRehearsalComesToItsEnd() throws InterruptedException {
        Rehearsal rehearsal = SmallRehearsal.start();
        while (!rehearsal.isOver()) {
            Thread.sleep(1);
        }
        assertThat(rehearsal.isOver()).isTrue();
    }

    private void warm() {
        FrameInput few = bodies(5);
        for (int frame = 0; frame < WARM; frame++) {
            assertThat(ways.walk(few)).isFalse();
        }
    }

    private static void assertSame(Engine vector, Engine sequential, FrameInput input) {
        assertThat(PictureDifference.between(pixels(vector, input), pixels(sequential, input))
                        .isWithinBound())
                .isTrue();
    }

    private static int[] pixels(Engine engine, FrameInput input) {
        Frame frame = Frame.ofPixels(input.width(), input.rows());
        engine.render(input, frame);
        return frame.argb();
    }

    /** A world with so many bodies, and room for {@link #ROOM}. */
    private static FrameInput bodies(int count) {
        World world = SampleWorld.crowd(ROOM, 96, 54);
        world.setBodyPositions(world.snapshot().bodyPositions(), count);
        return world.snapshot();
    }

    private Rehearsal start() {
        FakeRehearsal rehearsal = new FakeRehearsal();
        started.add(rehearsal);
        return rehearsal;
    }

    private static final class FakeRehearsal implements Rehearsal {
        private boolean over;
        private boolean closed;

        @Override
        public boolean isOver() {
            return over;
        }

        @Override
        public void close() {
            closed = true;
        }
    }
}
