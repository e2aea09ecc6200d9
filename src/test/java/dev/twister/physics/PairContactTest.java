package dev.twister.physics;

import static org.assertj.core.api.Assertions.assertThat;

import dev.twister.scene.Vector3;
import org.junit.jupiter.api.Test;

class PairContactTest {
    private static Met solved(Met met) {
        new PairContact(met.bodies(), met.surroundings()).solve(met.meeting(), 0, 1, 2);
        return met;
    }

    private static Met pair(double distance) {
        return Met.of(Motion.WEIGHTLESS, Motion.sphere(distance, 5, 0, 1), Motion.sphere(0, 5, 0, 1));
    }

    @Test
    void bodiesThatMeetFastBounce() {
        Met met = solved(pair(3).move(1, -2, 0, 0));

        assertThat(met.move(1)).isEqualTo(new Vector3(0, 0, 0));
        assertThat(met.move(2)).isEqualTo(new Vector3(-2, 0, 0));
    }

    @Test
    void aLoadedContactIsNoImpact() {
        Met met = pair(2).move(1, -2, 0, 0);
        met.meeting().setBuilt(0.5);

        solved(met);

        assertThat(met.move(1)).isEqualTo(met.move(2)).isEqualTo(new Vector3(-1, 0, 0));
    }

    @Test
    void distantBodiesAreLeftAlone() {
        Met met = solved(pair(3).move(1, -0.5, 0, 0));

        assertThat(met.move(1)).isEqualTo(new Vector3(-0.5, 0, 0));
    }

    @Test
    void anOverlapIsCorrectedByAShareWithoutSpeed() {
        Met met = solved(pair(1.98));

        assertThat(met.place(1).x() - met.place(2).x()).isBetween(1.98, 1.9821);
        assertThat(met.move(1)).isEqualTo(new Vector3(0, 0, 0));
    }

    @Test
    void coincidentBodiesPartAlongAnAxis() {
        Met met = solved(pair(0));

        assertThat(met.place(1)).isEqualTo(new Vector3(0.02, 5, 0));
        assertThat(met.place(2)).isEqualTo(new Vector3(-0.02, 5, 0));
    }
}
