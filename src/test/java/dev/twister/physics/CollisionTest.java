package dev.twister.physics;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import dev.twister.scene.Physics;
import dev.twister.scene.Sphere;
import dev.twister.scene.Vector3;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class CollisionTest {
    @ParameterizedTest
    @CsvSource({"1, 0.5, 0.5, 0", "0.6, 0.5, 1, 0.3", "0, 0.3, 0.9, -0.5", "1, 1, 0.2, 0.1"})
    void twoSpheresMeetByNewtonsLaw(double elasticity, double one, double two, double aside) {
        Physics physics = Motion.WEIGHTLESS.withElasticity(elasticity);
        try (Simulation simulation = Simulation.of(
                Motion.scene(physics, Motion.sphere(-3, 5, 0, one), Motion.sphere(3, 5 + aside, 0, two)))) {
            Motion.setVelocity(simulation, 1, 7, 0, 0);
            Motion.setVelocity(simulation, 2, -2, 0, 0);
            double[] before = momentum(simulation);
            double energy = motion(simulation);
            Motion.run(simulation, 1);

            double[] after = momentum(simulation);
            for (int axis = 0; axis < 3; axis++) {
                assertThat(after[axis]).isCloseTo(before[axis], within(1e-12));
            }
            // On impact, velocities along the line of centers change by the impulse; across it they do not.
            double sine = aside / (one + two);
            double cosine = Math.sqrt(1 - sine * sine);
            double along = (simulation.velocity(2, 0) - simulation.velocity(1, 0)) * cosine
                    + (simulation.velocity(2, 1) - simulation.velocity(1, 1)) * sine;
            assertThat(along).isCloseTo(elasticity * 9 * cosine, within(1e-9));
            double across = (simulation.velocity(2, 1) - simulation.velocity(1, 1)) * cosine
                    - (simulation.velocity(2, 0) - simulation.velocity(1, 0)) * sine;
            assertThat(across).isCloseTo(9 * sine, within(1e-9));
            double lost = (1 - elasticity * elasticity)
                    * 81
                    * cosine
                    * cosine
                    / 2
                    / (1 / Motion.mass(simulation, 1) + 1 / Motion.mass(simulation, 2));
            assertThat(motion(simulation)).isCloseTo(energy - lost, within(1e-9));
        }
    }

    @Test
    void massIsByVolume() {
        try (Simulation simulation = Simulation.of(
                Motion.scene(Physics.DEFAULT, Motion.sphere(-3, 5, 0, 0.5), Motion.sphere(3, 5, 0, 1.5)))) {
            assertThat(Motion.mass(simulation, 2) / Motion.mass(simulation, 1)).isCloseTo(27, within(1e-9));
        }
    }

    @ParameterizedTest
    @CsvSource({"1", "2"})
    void newtonsCradleLetsAsManyGoAsCome(int coming) {
        List<Sphere> spheres = new ArrayList<>();
        for (int i = 0; i < coming; i++) {
            spheres.add(Motion.sphere(-2 + 0.2 * i, 5, 0, 0.1));
        }
        for (int i = 0; i < 5; i++) {
            spheres.add(Motion.sphere(0.2 * i, 5, 0, 0.1));
        }
        int all = spheres.size();
        try (Simulation simulation = Simulation.of(Motion.scene(Motion.WEIGHTLESS, 50, spheres))) {
            for (int body = 1; body <= coming; body++) {
                Motion.setVelocity(simulation, body, 3, 0, 0);
            }
            Motion.run(simulation, 2);

            for (int body = 1; body <= all; body++) {
                assertThat(simulation.velocity(body, 0)).isCloseTo(body > all - coming ? 3 : 0, within(1e-9));
            }
        }
    }

    @Test
    void momentumIsKeptAndEnergyDoesNotGrowInACrowd() {
        Random random = new Random(5);
        List<Sphere> spheres = new ArrayList<>();
        for (int i = 0; i < 216; i++) {
            double radius = 0.2 + 0.2 * random.nextDouble();
            spheres.add(Motion.sphere(i % 6, 20 + Math.floorDiv(i, 6) % 6, Math.floorDiv(i, 36), radius));
        }
        Physics physics = Motion.WEIGHTLESS.withElasticity(0.9).withFriction(0.3);
        try (Simulation simulation = Simulation.of(Motion.scene(physics, 10, spheres))) {
            for (int body = 1; body <= 216; body++) {
                Motion.setVelocity(
                        simulation,
                        body,
                        random.nextGaussian() * 3,
                        random.nextGaussian() * 3,
                        random.nextGaussian() * 3);
            }
            double[] start = momentum(simulation);
            double energy = motion(simulation);
            double first = energy;
            for (int step = 0; step < 120; step++) {
                simulation.step();
                double now = motion(simulation);
                assertThat(now).isLessThanOrEqualTo(energy * (1 + 1e-12));
                energy = now;
            }
            assertThat(energy).isLessThan(0.9 * first);
            double[] end = momentum(simulation);
            for (int axis = 0; axis < 3; axis++) {
                assertThat(end[axis]).isCloseTo(start[axis], within(1e-9));
            }
        }
    }

    @Test
    void frictionStopsASlidingSphereAfterItsDistance() {
        Physics physics = Physics.DEFAULT.withFriction(0.4);
        try (Simulation simulation = Simulation.of(Motion.scene(physics, Motion.sphere(-8, 0.5, 0, 0.5)))) {
            Motion.run(simulation, 0.1);
            Motion.setVelocity(simulation, 1, 6, 0, 0);
            Motion.run(simulation, 3);

            // v^2 / (2 mu g)
            assertThat(Motion.place(simulation, 1, 0) + 8).isCloseTo(36 / (2 * 0.4 * Motion.GRAVITY), within(0.02));
            assertThat(Motion.speed(simulation, 1)).isZero();
        }
    }

    @Test
    void aSleeperTakesWhatHitsIt() {
        Physics physics = Physics.DEFAULT.withElasticity(1).withFriction(0);
        try (Simulation simulation =
                Simulation.of(Motion.scene(physics, Motion.sphere(-3, 0.5, 0, 0.5), Motion.sphere(0, 0.5, 0, 0.5)))) {
            Motion.run(simulation, 2);
            assertThat(Motion.sleepers(simulation)).isEqualTo(2);
            simulation.store().rouse(1);
            Motion.setVelocity(simulation, 1, 4, 0, 0);
            Motion.run(simulation, 1);

            assertThat(simulation.velocity(1, 0)).isCloseTo(0, within(1e-6));
            assertThat(simulation.velocity(2, 0)).isCloseTo(4, within(1e-6));
        }
    }

    @Test
    void gravityMayPullAnyWay() {
        Physics physics = Physics.DEFAULT.withGravity(new Vector3(3, 0, 0)).withElasticity(0);
        try (Simulation simulation = Simulation.of(Motion.scene(physics, Motion.sphere(0, 5, 0, 0.5)))) {
            Motion.run(simulation, 6);
            assertThat(Motion.place(simulation, 1, 0)).isCloseTo(9.5, within(0.01));
            assertThat(Motion.place(simulation, 1, 1)).isCloseTo(5, within(1e-6));
            assertThat(Motion.sleepers(simulation)).isEqualTo(1);
        }
    }

    private static double[] momentum(Simulation simulation) {
        double[] momentum = new double[3];
        for (int body = 1; body < simulation.store().count; body++) {
            for (int axis = 0; axis < 3; axis++) {
                momentum[axis] += Motion.mass(simulation, body) * simulation.velocity(body, axis);
            }
        }
        return momentum;
    }

    private static double motion(Simulation simulation) {
        double energy = 0;
        for (int body = 1; body < simulation.store().count; body++) {
            double speed = Motion.speed(simulation, body);
            energy += Motion.mass(simulation, body) * speed * speed / 2;
        }
        return energy;
    }
}
