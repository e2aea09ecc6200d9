package dev.twister.physics;

import static org.assertj.core.api.Assertions.assertThat;

import dev.twister.scene.Physics;
import dev.twister.scene.Sphere;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class NoTunnelTest {
    private static final double RADIUS = 0.05;

    @ParameterizedTest
    @ValueSource(doubles = {3, 30, 120, 500})
    void nothingPassesThroughGroundOrWalls(double speed) {
        try (Simulation simulation = Simulation.of(
                Motion.scene(Physics.DEFAULT, Motion.sphere(0, 3, 0, RADIUS), Motion.sphere(3, 3, 0, RADIUS)))) {
            Motion.setVelocity(simulation, 1, 0, -speed, 0);
            Motion.setVelocity(simulation, 2, speed, 0.1 * speed, 0.3 * speed);
            for (int step = 0; step < 240; step++) {
                simulation.step();
                for (int body = 1; body <= 2; body++) {
                    assertThat(Motion.place(simulation, body, 1)).isGreaterThan(0);
                    assertThat(Math.abs(Motion.place(simulation, body, 0))).isLessThan(10);
                    assertThat(Math.abs(Motion.place(simulation, body, 2))).isLessThan(10);
                }
            }
        }
    }

    @ParameterizedTest
    @ValueSource(doubles = {3, 30, 120, 500})
    void nothingPassesThroughAnotherSphere(double speed) {
        try (Simulation simulation = Simulation.of(
                Motion.scene(Motion.WEIGHTLESS, Motion.sphere(-5, 5, 0, RADIUS), Motion.sphere(5.013, 5, 0, RADIUS)))) {
            Motion.setVelocity(simulation, 1, speed, 0, 0);
            Motion.setVelocity(simulation, 2, -speed, 0, 0);
            // The spheres meet after 5 meters each.
            for (double way = 0; way < 8; way += speed * Simulation.STEP_SECONDS) {
                simulation.step();
                assertThat(Motion.place(simulation, 1, 0)).isLessThan(Motion.place(simulation, 2, 0));
            }
            assertThat(simulation.velocity(1, 0)).isNegative();
            assertThat(simulation.velocity(2, 0)).isPositive();
        }
    }

    @Test
    void aMissIsAMiss() {
        try (Simulation simulation = Simulation.of(
                Motion.scene(Motion.WEIGHTLESS, Motion.sphere(-5, 5, 0, RADIUS), Motion.sphere(0, 5.101, 0, RADIUS)))) {
            Motion.setVelocity(simulation, 1, 60, 0, 0);
            Motion.run(simulation, 1);
            assertThat(Motion.place(simulation, 1, 1)).isEqualTo(5);
            assertThat(Motion.speed(simulation, 2)).isZero();
        }
    }

    @Test
    void nothingIsFasterThanTheLimit() {
        try (Simulation simulation = Simulation.of(Motion.scene(Motion.WEIGHTLESS, Motion.sphere(0, 5, 0, RADIUS)))) {
            Motion.setVelocity(simulation, 1, 900, 0, 0);
            simulation.step();
            assertThat(simulation.velocity(1, 0)).isBetween(499.999, 500.001);
        }
    }

    @Test
    void spheresAtOnePointPartWithoutAnExplosion() {
        List<Sphere> spheres = new ArrayList<>();
        for (int i = 0; i < 30; i++) {
            spheres.add(Motion.sphere(0, 2, 0, 0.2));
        }
        try (Simulation simulation = Simulation.of(Motion.scene(Physics.DEFAULT, 20, spheres))) {
            for (int step = 0; step < 600; step++) {
                simulation.step();
                for (int body = 1; body <= 30; body++) {
                    // Free fall from their start height cannot be faster.
                    assertThat(Motion.speed(simulation, body)).isLessThan(7);
                }
            }
            assertThat(Motion.deepestOverlap(simulation)).isLessThan(0.02);
        }
    }

    @Test
    void aSmallSphereUnderALargeOneStaysAboveTheGround() {
        try (Simulation simulation = Simulation.of(
                Motion.scene(Physics.DEFAULT, Motion.sphere(0, 0.05, 0, 0.05), Motion.sphere(0, 4, 0, 2)))) {
            Motion.run(simulation, 5);
            assertThat(Motion.place(simulation, 1, 1)).isGreaterThan(0);
            assertThat(Motion.place(simulation, 2, 1)).isGreaterThan(1.9);
        }
    }

    @Test
    void spheresFallOffThePlaneWithoutWallsOnly() {
        for (boolean walls : new boolean[] {true, false}) {
            Physics physics = Physics.DEFAULT.withWalls(walls).withFriction(0);
            try (Simulation simulation = Simulation.of(Motion.scene(physics, Motion.sphere(9, 0.5, 0, 0.5)))) {
                Motion.setVelocity(simulation, 1, 3, 0, 0);
                Motion.run(simulation, 30);
                if (walls) {
                    assertThat(Motion.place(simulation, 1, 1)).isBetween(0.49, 0.51);
                } else {
                    // The body stops below the visible range and its position stays finite.
                    assertThat(Motion.place(simulation, 1, 1)).isBetween(-1200.0, -1000.0);
                    assertThat(Motion.sleepers(simulation)).isEqualTo(1);
                }
            }
        }
    }
}
