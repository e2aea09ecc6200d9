package dev.twister.physics;

import static org.assertj.core.api.Assertions.assertThat;

import dev.twister.scene.Physics;
import dev.twister.scene.Vector3;
import org.junit.jupiter.api.Test;

class FirmContactTest {
    private static final Physics PHYSICS = Physics.DEFAULT.withFriction(0);

    /** A light body of radius 0.1 at a height, under a heavy one of radius 1 that touches it. */
    private static Met above(double height) {
        Met met = Met.of(PHYSICS, Motion.sphere(0, height, 0, 0.1), Motion.sphere(0, height + 1.1, 0, 1))
                .move(2, 0, -0.01, 0);
        met.between(1, 2).meeting().setNormal(0, -1, 0);
        return met;
    }

    private static boolean solve(Met met) {
        return new FirmContact(met.bodies(), met.surroundings()).solve(met.meeting(), 1.1, 1.1, 0);
    }

    @Test
    void aLightBodyOnTheGroundHoldsAHeavyOne() {
        Met met = above(0.1);

        assertThat(solve(met)).isTrue();

        assertThat(met.move(2)).isEqualTo(new Vector3(0, 0, 0));
        assertThat(met.move(1)).isEqualTo(new Vector3(0, 0, 0));
        assertThat(met.meeting().built())
                .as("negative: the light body carries none of it")
                .isEqualTo(-0.01);
        assertThat(met.meeting().impulses[1]).as("acts on the first body").isEqualTo(-0.01);
    }

    @Test
    void aSleepingLightBodyIsNotTouched() {
        Met met = above(3);
        met.bodies().sleep(1);

        assertThat(solve(met)).isTrue();

        assertThat(met.move(2)).isEqualTo(new Vector3(0, 0, 0));
        assertThat(met.place(1)).isEqualTo(new Vector3(0, 3, 0));
    }

    @Test
    void aLightBodyInTheAirYields() {
        Met met = above(3);
        met.meeting().setBuilt(-5);

        assertThat(solve(met)).isFalse();

        assertThat(met.move(2)).isEqualTo(new Vector3(0, -0.01, 0));
        assertThat(met.meeting().built()).as("a load that it no longer bears").isZero();
    }
}
