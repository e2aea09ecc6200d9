package dev.twister.engine.vector;

import static org.assertj.core.api.Assertions.assertThat;

import dev.twister.engine.Engine;
import dev.twister.engine.Engines;
import dev.twister.image.Frame;
import dev.twister.oracle.PictureDifference;
import dev.twister.world.FrameInput;
import dev.twister.world.Positions;
import dev.twister.world.SampleWorld;
import dev.twister.world.World;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class HierarchyChoiceTest {
    private static final int CROWD = 20;
    private static final int ROOM = 10 * CROWD;

    /** More frames than an engine needs for warm-up. */
    private static final int WARM = 100;

    /** A small world without room for more bodies. */
    private static final FrameInput FEW = SampleWorld.ofSize(4, 4).snapshot();

    private final List<FakeRehearsal> started = new ArrayList<>();
    private final HierarchyChoice ways = new HierarchyChoice(CROWD, this::start);

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

    @ParameterizedTest
    @ValueSource(booleans = {true, false})
    void aCrowdIsWalkedThroughWhetherTheRehearsalIsOverOrNot(boolean over) {
        warm();
        started.getFirst().over = over;
        assertThat(ways.walk(bodies(CROWD))).isTrue();
        assertThat(ways.walk(bodies(CROWD - 1))).isFalse();
        assertThat(started).hasSize(1).allMatch(rehearsal -> rehearsal.closed != over);
    }

    @Test
    void nothingIsRehearsedForAFewThatStayAFew() {
        for (int frame = 0; frame < WARM; frame++) {
            ways.walk(FEW);
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
    void atRestTheWayNotTakenYetIsRehearsed() {
        ways.rest();
        assertThat(started).isEmpty();

        ways.walk(FEW);
        ways.rest();
        ways.rest();
        assertThat(started).hasSize(1).allMatch(rehearsal -> rehearsal.walk);
        started.getFirst().over = true;
        ways.walk(FEW);
        ways.rest();
        assertThat(started).hasSize(1);

        assertThat(ways.walk(bodies(CROWD))).isTrue();
        ways.rest();
        assertThat(started).hasSize(1);
    }

    @Test
    void afterACrowdItIsTheWayOfTheFew() {
        ways.walk(bodies(CROWD));
        ways.rest();
        assertThat(started).hasSize(1).noneMatch(rehearsal -> rehearsal.walk);
    }

    @Test
    void aFrameEndsARehearsalAtRestThatTheNextRestTakesUpAgain() {
        ways.walk(FEW);
        ways.rest();
        ways.walk(FEW);
        assertThat(started).hasSize(1).allMatch(rehearsal -> rehearsal.closed);
        ways.rest();
        assertThat(started).hasSize(2);
    }

    @Test
    void aCrowdThatComesWhileItIsRehearsedAtRestEndsTheRehearsal() {
        ways.walk(FEW);
        ways.rest();
        assertThat(ways.walk(bodies(CROWD))).isTrue();
        assertThat(started).hasSize(1).allMatch(rehearsal -> rehearsal.closed);
    }

    @Test
    void closingEndsARehearsal() {
        warm();
        ways.close();
        assertThat(started).hasSize(1).allMatch(rehearsal -> rehearsal.closed);
    }

    @ParameterizedTest
    @ValueSource(ints = {CROWD, CROWD + 11})
    void bothWaysDrawTheSamePicture(int crowd) {
        try (Engine vector = VectorEngines.open(2, crowd);
                Engine sequential = Engines.open("sequential")) {
            assertSame(vector, sequential, bodies(CROWD + 10));
        }
    }

    @Tag("slow")
    @ParameterizedTest
    @ValueSource(booleans = {true, false})
    @Timeout(300)
    void aRehearsalComesToItsEnd(boolean walk) throws InterruptedException {
        Rehearsal rehearsal = VectorEngines.SmallRehearsal.of(walk);
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

    /** A world with this number of bodies and room for {@link #ROOM}. */
    private static FrameInput bodies(int count) {
        World world = SampleWorld.crowd(ROOM, 96, 54);
        world.setBodyPositions(Positions.of(world.snapshot()), count);
        return world.snapshot();
    }

    private Rehearsal start(boolean walk) {
        FakeRehearsal rehearsal = new FakeRehearsal(walk);
        started.add(rehearsal);
        return rehearsal;
    }

    private static final class FakeRehearsal implements Rehearsal {
        private final boolean walk;
        private boolean over;
        private boolean closed;

        FakeRehearsal(boolean walk) {
            this.walk = walk;
        }

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
