package dev.twister.physics;

import static org.assertj.core.api.Assertions.assertThat;

import dev.twister.scene.Physics;
import dev.twister.scene.Vector3;
import org.junit.jupiter.api.Test;

class RestingContactTest {
    private static final Vector3 ZERO = new Vector3(0, 0, 0);

    private static Met touching(Physics physics) {
        Met met = Met.of(physics, Motion.sphere(2, 5, 0, 1), Motion.sphere(0, 5, 0, 1));
        met.meeting().setNormal(1, 0, 0);
        return met;
    }

    private static void hold(Met met, double gap, double push) {
        new RestingContact(met.bodies()).hold(met.between(1, 2).meeting(), 1, 1, 1, gap, push);
    }

    @Test
    void stopsBodiesThatApproach() {
        Met met = touching(Physics.DEFAULT.withFriction(0)).move(1, -0.5, 0, 0);

        hold(met, 0, 0);

        assertThat(met.move(1)).isEqualTo(new Vector3(-0.25, 0, 0));
        assertThat(met.move(2)).isEqualTo(new Vector3(-0.25, 0, 0));
        assertThat(met.meeting().impulses).containsExactly(0.25, 0, 0, 0.25);
        assertThat(met.support(1)).isEqualTo(new Vector3(0.25, 0, 0));
        assertThat(met.support(2)).isEqualTo(new Vector3(-0.25, 0, 0));
    }

    @Test
    void letsThemCloseAGap() {
        Met met = touching(Physics.DEFAULT.withFriction(0)).move(1, -0.5, 0, 0);

        hold(met, 0.25, 0);

        assertThat(met.move(1)).isEqualTo(new Vector3(-0.375, 0, 0));
        assertThat(met.move(2)).isEqualTo(new Vector3(-0.125, 0, 0));
    }

    @Test
    void frictionIsAtMostAShareOfTheLoad() {
        Met met = touching(Physics.DEFAULT.withFriction(0.5)).move(1, -0.5, 0, 8);

        hold(met, 0, 0);

        assertThat(met.meeting().impulses[2]).isEqualTo(-0.125);
        assertThat(met.move(1).z()).isEqualTo(7.875);
        assertThat(met.move(2).z()).isEqualTo(0.125);
    }

    @Test
    void pushesBothApartWithoutSpeed() {
        Met met = touching(Physics.DEFAULT);

        hold(met, 0, 0.5);

        assertThat(met.place(1).x()).isEqualTo(2.25);
        assertThat(met.place(2).x()).isEqualTo(-0.25);
        assertThat(met.move(1)).isEqualTo(ZERO);
    }

    @Test
    void aLoadGrowsByAtMostEightWeights() {
        Met met = touching(Physics.DEFAULT.withFriction(0).withGravity(new Vector3(0, -0.0078125, 0)))
                .move(1, -0.5, 0, 0);

        hold(met, 0, 0);

        assertThat(met.meeting().built()).isEqualTo(8 * 0.0078125);
        assertThat(met.move(1).x()).isEqualTo(-0.25);
    }
}
