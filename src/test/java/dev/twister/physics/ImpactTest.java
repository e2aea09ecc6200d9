package dev.twister.physics;

import static org.assertj.core.api.Assertions.assertThat;

import dev.twister.scene.Physics;
import dev.twister.scene.Vector3;
import org.junit.jupiter.api.Test;

class ImpactTest {
    private static final Physics ELASTIC = Motion.WEIGHTLESS;

    /** Two bodies of radius 1 with centers 3 apart along x. */
    private static Met apart(double firstMove) {
        Met met = Met.of(ELASTIC, Motion.sphere(3, 5, 0, 1), Motion.sphere(0, 5, 0, 1))
                .move(1, firstMove, 0, 0)
                .between(1, 2);
        met.meeting().setPlace(3, 0, 0, 9 - 4, 3 * firstMove);
        return met;
    }

    @Test
    void equalBodiesExchangeTheirSpeeds() {
        Met met = apart(-2);
        met.meeting().impulses[Contacts.BUILT] = 7;

        assertThat(new Impact(met.bodies()).resolve(met.meeting(), false)).isTrue();

        assertThat(met.move(1)).isEqualTo(new Vector3(0, 0, 0));
        assertThat(met.move(2)).isEqualTo(new Vector3(-2, 0, 0));
        // Half of the sub-step passes before they meet, so that each move counts for half.
        assertThat(met.place(1).x()).isEqualTo(3 - 1);
        assertThat(met.place(2).x()).isEqualTo(1);
        assertThat(met.meeting().built()).isZero();
    }

    @Test
    void aFirmBodyIsNotMoved() {
        Met met = apart(-2);

        assertThat(new Impact(met.bodies()).resolve(met.meeting(), true)).isTrue();

        assertThat(met.move(1)).isEqualTo(new Vector3(2, 0, 0));
        assertThat(met.move(2)).isEqualTo(new Vector3(0, 0, 0));
    }

    @Test
    void bodiesThatDoNotMeetInTheSubstepAreLeftAlone() {
        Met met = apart(-0.5);

        assertThat(new Impact(met.bodies()).resolve(met.meeting(), false)).isFalse();

        assertThat(met.move(1)).isEqualTo(new Vector3(-0.5, 0, 0));
    }

    @Test
    void missesAreFoundWithoutARoot() {
        assertThat(Impact.missed(5, 3, 1)).as("apart").isTrue();
        assertThat(Impact.missed(5, -1.5, 0.25)).as("later").isTrue();
        assertThat(Impact.missed(5, -1, 4)).as("aside").isTrue();
        assertThat(Impact.missed(5, -6, 4)).as("met").isFalse();
    }
}
