package dev.twister.physics;

import static org.assertj.core.api.Assertions.assertThat;

import dev.twister.scene.Physics;
import dev.twister.scene.Scene;
import dev.twister.scene.Sphere;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** A sphere of radius 5 on small ones, at mass ratios from 8 to 125,000. */
class UnequalSpheresTest {
    private static final double HEAVY = 5;

    /** Allowed overlap in small radii. */
    private static final double MOST_OVERLAP = 0.05;

    private static final double MOST_GAIN = 1e-4;

    @ParameterizedTest
    @CsvSource({"2.5, 0.2", "1.25, 0.2", "0.5, 0.2", "0.25, 0.2", "0.1, 0.2", "0.1, 0", "0.5, 3", "0.1, 3"})
    void aHeavySphereStaysOnLightOnes(double radius, double gap) {
        Scene scene = Motion.scene(Physics.DEFAULT, 40, onThree(radius, gap));

        assertStaysOut(scene, 5);
    }

    @ParameterizedTest
    @CsvSource({"0, 0.5", "1, 0.5", "0.3, 0", "0.3, 0.9"})
    void itDoesAtAnyFrictionAndElasticity(double friction, double elasticity) {
        Physics physics = Physics.DEFAULT.withFriction(friction).withElasticity(elasticity);

        assertStaysOut(Motion.scene(physics, 40, onThree(0.1, 0.2)), 5);
    }

    @ParameterizedTest
    @ValueSource(doubles = {1.25, 0.5, 0.1})
    void aHeavySphereThatStartsInLightOnesComesOut(double radius) {
        try (Simulation simulation = Simulation.of(Motion.scene(Physics.DEFAULT, 40, onThree(radius, -radius)))) {
            for (int step = 0; step < 240; step++) {
                simulation.step();
                for (int body = 1; body < simulation.store().count; body++) {
                    assertThat(Motion.speed(simulation, body)).isLessThan(1);
                }
            }
            assertThat(deepestOverlap(simulation)).isLessThan(MOST_OVERLAP);
        }
    }

    @Test
    void aHeavySphereStaysOnMiddleOnesOnLightOnes() {
        List<Sphere> spheres = new ArrayList<>();
        List<Sphere> upper = onThree(1, 0);
        for (Sphere middle : upper.subList(0, 3)) {
            double x = middle.position().x();
            double z = middle.position().z();
            for (int corner = 0; corner < 3; corner++) {
                double angle = 2 * Math.PI * corner / 3;
                spheres.add(Motion.sphere(x + 0.15 * Math.cos(angle), 0.1, z + 0.15 * Math.sin(angle), 0.1));
            }
            spheres.add(Motion.sphere(x, 1.25, z, 1));
        }
        Sphere heavy = upper.getLast();
        spheres.add(Motion.sphere(
                heavy.position().x(),
                heavy.position().y() + 0.5,
                heavy.position().z(),
                HEAVY));

        assertStaysOut(Motion.scene(Physics.DEFAULT, 40, spheres), 4);
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 2, 4})
    void aHeavySphereStaysOnABedOfLightOnes(int layers) {
        List<Sphere> spheres = new ArrayList<>();
        for (int layer = 0; layer < layers; layer++) {
            double shift = layer % 2 == 0 ? 0 : 0.1;
            for (int x = -6; x <= 6; x++) {
                for (int z = -6; z <= 6; z++) {
                    spheres.add(Motion.sphere(0.21 * x + shift, 0.1 + 0.17 * layer, 0.21 * z + shift, 0.1));
                }
            }
        }
        spheres.add(Motion.sphere(0, HEAVY + 0.3 + 0.2 * layers, 0, HEAVY));

        assertStaysOut(Motion.scene(Physics.DEFAULT, 40, spheres), 1.5);
    }

    @Test
    void aLightSphereBetweenTwoHeavyOnesKeepsThemApart() {
        Scene scene = Motion.scene(
                Physics.DEFAULT,
                40,
                List.of(Motion.sphere(0, 3, 0, 3), Motion.sphere(0, 6.1, 0, 0.1), Motion.sphere(0.05, 10.3, 0, 4)));

        assertStaysOut(scene, 1);
    }

    private static void assertStaysOut(Scene scene, double seconds) {
        try (Simulation simulation = Simulation.of(scene)) {
            double most = 0;
            for (int step = 0; step < seconds / Simulation.STEP_SECONDS; step += 12) {
                most = Motion.runWithoutGain(simulation, 12, 0, most, MOST_GAIN);
                assertThat(deepestOverlap(simulation))
                        .as("overlap at %.3f s", simulation.seconds())
                        .isLessThan(MOST_OVERLAP);
            }
        }
    }

    /** Three spheres on the ground with a heavy one on top. */
    private static List<Sphere> onThree(double radius, double gap) {
        double apart = 3 * radius;
        double middle = apart / Math.sqrt(3);
        double up = radius + Math.sqrt((HEAVY + radius) * (HEAVY + radius) - middle * middle);
        return List.of(
                Motion.sphere(0, radius, 0, radius),
                Motion.sphere(apart, radius, 0, radius),
                Motion.sphere(apart / 2, radius, apart * Math.sqrt(0.75), radius),
                Motion.sphere(apart / 2, up + gap, middle / 2, HEAVY));
    }

    /** Deepest overlap of two spheres or of a sphere and the ground, in radii of the smaller one. */
    private static double deepestOverlap(Simulation simulation) {
        double deepest = 0;
        for (int one = 1; one < simulation.store().count; one++) {
            double radius = Motion.radius(simulation, one);
            deepest = Math.max(deepest, 1 - Motion.place(simulation, one, 1) / radius);
            for (int other = one + 1; other < simulation.store().count; other++) {
                double radii = radius + Motion.radius(simulation, other);
                double smaller = Math.min(radius, Motion.radius(simulation, other));
                deepest = Math.max(deepest, Motion.overlap(simulation, one, other) * radii / smaller);
            }
        }
        return deepest;
    }
}
