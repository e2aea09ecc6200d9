package dev.twister.physics;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

class WakingTest {
    private static final double LIMIT = 0.01;

    private final Met met = Met.of(Motion.WEIGHTLESS, Motion.sphere(0, 5, 0, 1), Motion.sphere(2.1, 5, 0, 0.5));
    private final BodyStore bodies = met.bodies();
    private final Waking waking = new Waking(bodies);

    @BeforeEach
    void putTheSecondToSleep() {
        bodies.sleep(2);
    }

    @Test
    void aFastBodyNearbyWakesASleepingOne() {
        met.move(1, 0.1, 0, 0);

        waking.wake(1, 2, 1.6 * 1.6, 1.5, LIMIT);

        assertThat(bodies.state[2]).isEqualTo(BodyStore.WOKEN);
    }

    @Test
    void aSlowOrDistantBodyDoesNot() {
        met.move(1, 0.05, 0, 0);
        waking.wake(1, 2, 1.6 * 1.6, 1.5, LIMIT);
        met.move(1, 1, 0, 0);
        waking.wake(1, 2, 1.7 * 1.7, 1.5, LIMIT);

        assertThat(bodies.state[2]).isEqualTo(BodyStore.ASLEEP);
    }

    @Test
    void aWokenBodyMovesInAnImpact() {
        assertThat(waking.inverseMassWhenHit(2 * BodyStore.STRIDE)).isZero();
        bodies.rouse(2);

        assertThat(waking.inverseMassWhenHit(2 * BodyStore.STRIDE)).isEqualTo(8);
        assertThat(waking.inverseMassAwake(2)).isEqualTo(8);
        assertThat(waking.inverseMassAwake(BodyStore.FIRST_LIGHT)).isZero();
    }
}
