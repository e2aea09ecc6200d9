package dev.twister.physics;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import dev.twister.scene.Light;
import dev.twister.scene.Physics;
import dev.twister.scene.Scene;
import dev.twister.scene.Vector3;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class BounceTest {
    private static final double RADIUS = 0.5;

    @ParameterizedTest
    @ValueSource(doubles = {1, 0.9, 0.7, 0.5})
    void heightsFallByTheSquareOfTheElasticity(double elasticity) {
        double height = 3;
        Physics physics = Physics.DEFAULT.withElasticity(elasticity);
        List<Double> peaks = new ArrayList<>();
        try (Simulation simulation =
                Simulation.of(Motion.scene(physics, Motion.sphere(0, RADIUS + height, 0, RADIUS)))) {
            double before = 0;
            for (int step = 0; step < 600; step++) {
                simulation.step();
                double velocity = simulation.velocity(1, 1);
                if (velocity > 0 && before <= 0) {
                    // The height that the sphere will reach.
                    peaks.add(Motion.place(simulation, 1, 1) - RADIUS + velocity * velocity / 2 / Motion.GRAVITY);
                }
                before = velocity;
            }
        }
        assertThat(peaks).hasSizeGreaterThanOrEqualTo(3);
        for (int bounce = 0; bounce < 3; bounce++) {
            double exact = height * Math.pow(elasticity, 2 * (bounce + 1));
            assertThat(peaks.get(bounce)).isCloseTo(exact, within(1e-6 * height));
        }
    }

    @Test
    void landsWhenItShould() {
        Physics physics = Physics.DEFAULT.withElasticity(1);
        double fall = Math.sqrt(2 * 3 / Motion.GRAVITY);
        try (Simulation simulation = Simulation.of(Motion.scene(physics, Motion.sphere(0, RADIUS + 3, 0, RADIUS)))) {
            Motion.run(simulation, Math.round(2 * fall / Simulation.STEP_SECONDS) * Simulation.STEP_SECONDS);
            double late = simulation.seconds() - 2 * fall;
            // Upward again, up to the rounding of the time.
            assertThat(simulation.velocity(1, 1)).isCloseTo(-Motion.GRAVITY * late, within(0.05));
        }
    }

    @Test
    void bouncesOffAWall() {
        Physics physics = Motion.WEIGHTLESS.withElasticity(0.5).withWalls(true);
        try (Simulation simulation = Simulation.of(Motion.scene(physics, Motion.sphere(0, 3, 0, RADIUS)))) {
            Motion.setVelocity(simulation, 1, 8, 0, 0);
            Motion.run(simulation, 2);

            // 1.1875 s to the wall at 10 - 0.5, then back at half the speed.
            assertThat(simulation.velocity(1, 0)).isCloseTo(-4, within(1e-9));
            assertThat(Motion.place(simulation, 1, 0)).isCloseTo(9.5 - 4 * (2 - 1.1875), within(1e-9));
        }
    }

    @Test
    void bouncesOffTheGroundFromBelow() {
        try (Simulation simulation = Simulation.of(Motion.scene(Motion.WEIGHTLESS, Motion.sphere(0, -3, 0, RADIUS)))) {
            Motion.setVelocity(simulation, 1, 0, 5, 0);
            Motion.run(simulation, 1);

            assertThat(Motion.place(simulation, 1, 1)).isCloseTo(-3, within(1e-9));
            assertThat(simulation.velocity(1, 1)).isCloseTo(-5, within(1e-9));
        }
    }

    @Test
    void bouncesOffTheLightWhereItIsSolid() {
        Physics solid = Motion.WEIGHTLESS.withSolidLight(true);
        for (Physics physics : List.of(solid, solid.withSolidLight(false))) {
            try (Simulation simulation = Simulation.of(Motion.scene(physics, Motion.sphere(0, 40, 0, RADIUS)))) {
                Motion.setVelocity(simulation, 1, 0, 20, 0);
                Motion.run(simulation, 1);

                // The light is at 50 and has a radius of 1.
                double exact = physics.solidLight() ? 48.5 - (20 - 8.5) : 60;
                assertThat(Motion.place(simulation, 1, 1)).isCloseTo(exact, within(1e-9));
            }
        }
    }

    @Test
    void bouncesOffEveryLightWhereLightsAreSolid() {
        Scene scene = Motion.scene(Motion.WEIGHTLESS.withSolidLight(true), Motion.sphere(0, 10, 0, RADIUS));
        Light low = scene.lights().first().withPosition(new Vector3(0, 20, 0));
        Scene two = scene.withLights(scene.lights().with(List.of(low)));
        try (Simulation simulation = Simulation.of(two)) {
            Motion.setVelocity(simulation, 2, 0, 20, 0);
            Motion.run(simulation, 1);

            assertThat(Motion.place(simulation, 2, 1)).isCloseTo(18.5 - (20 - 8.5), within(1e-9));
            assertThat(simulation.positions()).hasSize(3 * 3);
        }
    }
}
