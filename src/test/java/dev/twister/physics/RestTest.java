package dev.twister.physics;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import dev.twister.scene.Physics;
import dev.twister.scene.Scene;
import dev.twister.scene.Sphere;
import dev.twister.scene.Vector3;
import dev.twister.scene.generate.Pour;
import dev.twister.world.SceneMeshes;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class RestTest {
    private static final double TEN_MINUTES = 600;

    @ParameterizedTest
    @ValueSource(ints = {1, 2, 5, 10, 20})
    void stacksStand(int height) {
        List<Sphere> spheres = new ArrayList<>();
        for (int i = 0; i < height; i++) {
            spheres.add(Motion.sphere(0, 0.1 + 0.2 * i, 0, 0.1));
        }
        try (Simulation simulation = Simulation.of(Motion.scene(Physics.DEFAULT, 20, spheres))) {
            Motion.run(simulation, TEN_MINUTES);

            assertThat(Motion.sleepers(simulation)).isEqualTo(height);
            for (int body = 1; body <= height; body++) {
                assertThat(Math.hypot(Motion.place(simulation, body, 0), Motion.place(simulation, body, 2)))
                        .isLessThan(1e-9);
                double exact = 0.1 + 0.2 * (body - 1);
                assertThat(Motion.place(simulation, body, 1)).isCloseTo(exact, within(0.01 * exact));
            }
        }
    }

    @Test
    void aSmallSphereStaysWedgedBetweenTwoLargeOnes() {
        List<Sphere> spheres = new ArrayList<>();
        spheres.add(Motion.sphere(-1.25, 1, 0, 1));
        spheres.add(Motion.sphere(1.25, 1, 0, 1));
        spheres.add(Motion.sphere(0, 0.26, 0, 0.25));
        try (Simulation simulation = Simulation.of(Motion.scene(Physics.DEFAULT, 20, spheres))) {
            Motion.run(simulation, 10);
            double[] places = heights(simulation);
            Motion.run(simulation, TEN_MINUTES);
            assertThat(heights(simulation)).containsExactly(places);
        }
    }

    @Test
    void aPileOfAThousandComesToRestAndStaysThere() {
        Pour pour = Pour.DEFAULT
                .withCount(1000)
                .withRate(250)
                .withPosition(new Vector3(0, 3, 0))
                .withWidth(1.6)
                .withSpeed(3)
                .withRadii(0.07, 0.13);
        Scene scene = Motion.scene(Physics.DEFAULT, 8, List.of()).withPour(pour);
        try (Simulation simulation = Simulation.of(scene, SceneMeshes.NONE, 1)) {
            Motion.run(simulation, 12);

            assertThat(Motion.sleepers(simulation)).isEqualTo(1000);
            assertThat(Motion.deepestOverlap(simulation)).isLessThan(0.02);
            float[] places = simulation.positions();
            Motion.run(simulation, TEN_MINUTES);
            assertThat(simulation.positions()).containsExactly(places);
            for (int body = 1; body <= 1000; body++) {
                assertThat(Motion.place(simulation, body, 1)).isGreaterThan(Motion.radius(simulation, body) * 0.97);
            }
        }
    }

    /**
     * A sub-step starts with the loads of the previous one, which may be slightly too high: the gain is at most 5.1e-5
     * in seeds 3 to 102. Seeds 19 and 86 detect shocks that are carried on: 2 % and 0.4 %.
     */
    @ParameterizedTest
    @ValueSource(ints = {3, 4, 19, 86})
    void energyDoesNotGrowWhileAHeapFallsTogether(int seed) {
        Random random = new Random(seed);
        List<Sphere> spheres = new ArrayList<>();
        for (int i = 0; i < 400; i++) {
            double jitter = 0.05 * random.nextDouble();
            spheres.add(Motion.sphere(
                    0.3 * (i % 5) + jitter,
                    0.5 + 0.3 * Math.floorDiv(i, 25),
                    0.3 * (Math.floorDiv(i, 5) % 5) - jitter,
                    0.08 + 0.04 * random.nextDouble()));
        }
        try (Simulation simulation = Simulation.of(Motion.scene(Physics.DEFAULT, 6, spheres))) {
            double start = Motion.energy(simulation);
            double before = start;
            for (int step = 0; step < 600; step++) {
                simulation.step();
                double energy = Motion.energy(simulation);
                assertThat(energy).isLessThan(before + 1e-4 * start).isLessThanOrEqualTo(start * (1 + 1e-12));
                before = energy;
            }
            assertThat(before).isLessThan(0.4 * start);
        }
    }

    private static double[] heights(Simulation simulation) {
        double[] heights = new double[simulation.store().count];
        for (int body = 1; body < heights.length; body++) {
            heights[body] = Motion.place(simulation, body, 1);
        }
        return heights;
    }
}
