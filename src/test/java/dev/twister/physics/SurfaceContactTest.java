package dev.twister.physics;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import dev.twister.scene.Physics;
import dev.twister.scene.Vector3;
import org.junit.jupiter.api.Test;

class SurfaceContactTest {
    private static final Physics PHYSICS = Motion.WEIGHTLESS.withElasticity(0.5);

    private static Met solved(Physics physics, double x, double y, Vector3 move, int surface) {
        Met met = Met.of(physics, Motion.sphere(x, y, 0, 1)).move(1, move.x(), move.y(), move.z());
        new SurfaceContact(met.bodies(), met.surroundings()).solve(met.meeting(), 0, 1, surface);
        return met;
    }

    @Test
    void aFastBodyBouncesOffTheGround() {
        Met met = solved(PHYSICS, 0, 1.5, new Vector3(0, -1, 0), Surroundings.GROUND);

        assertThat(met.move(1).y()).isEqualTo(0.5);
        assertThat(met.place(1).y() + met.move(1).y())
                .as("after half a sub-step each")
                .isEqualTo(1 + 0.25);
    }

    @Test
    void aSlowBodyComesToRest() {
        Met met = solved(
                PHYSICS.withGravity(new Vector3(0, -100, 0)), 0, 1, new Vector3(0, -0.25, 0), Surroundings.GROUND);

        assertThat(met.move(1)).isEqualTo(new Vector3(0, 0, 0));
        assertThat(met.meeting().built()).isEqualTo(0.25);
    }

    @Test
    void aBodyThatMissesTheGroundIsLeftAlone() {
        Met met = solved(PHYSICS, 0, 3, new Vector3(0, -1, 0), Surroundings.GROUND);

        assertThat(met.move(1)).isEqualTo(new Vector3(0, -1, 0));
        assertThat(met.place(1)).isEqualTo(new Vector3(0, 3, 0));
    }

    @Test
    void wallsPushInward() {
        Met met = solved(PHYSICS, 9, 5, new Vector3(1, 0, 0), Surroundings.FIRST_WALL);

        assertThat(met.move(1).x()).isEqualTo(-0.5);
    }

    @Test
    void theBorderPushesAway() {
        Met met = solved(PHYSICS, 10.6, 0.8, new Vector3(-0.6, -0.8, 0), Surroundings.GROUND);

        assertThat(met.move(1).x()).isCloseTo(0.3, within(1e-9));
        assertThat(met.move(1).y()).isCloseTo(0.4, within(1e-9));
    }

    @Test
    void sleepingBodiesStay() {
        Met met = Met.of(PHYSICS, Motion.sphere(0, 0.5, 0, 1));
        met.bodies().sleep(1);

        new SurfaceContact(met.bodies(), met.surroundings()).solve(met.meeting(), 0, 1, Surroundings.GROUND);

        assertThat(met.place(1).y()).isEqualTo(0.5);
    }
}
