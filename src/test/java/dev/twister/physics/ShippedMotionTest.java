package dev.twister.physics;

import static org.assertj.core.api.Assertions.assertThat;

import dev.twister.scene.Scene;
import dev.twister.scene.format.SceneReader;
import dev.twister.scene.generate.SceneGenerator;
import dev.twister.world.SceneMeshes;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Comparator;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledIfSystemProperty;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** The shipped scenes in motion; {@code -Dtwister.motion=10} sets the simulated minutes, at least 1. */
@EnabledIfSystemProperty(named = "twister.motion", matches = "\\d+")
class ShippedMotionTest {
    private static final long SECONDS = 60 * Long.getLong("twister.motion", 1);
    private static final int STEPS_A_SECOND = (int) Math.round(1 / Simulation.STEP_SECONDS);

    /** Allowed penetration, as a fraction of the sum of the two radii, in motion and at rest. */
    private static final double DEEPEST = 0.25;

    private static final double DEEPEST_AT_REST = 0.05;

    /** Allowed penetration of the ground or a wall at any time, as a fraction of the radius. */
    private static final double DEEPEST_IN_SURFACES = 0.25;

    /** Allowed gain per step by loads that were too high, as a fraction of the maximum energy so far. */
    private static final double MOST_GAIN = 1e-4;

    private static final int FIRST_SEED = 101;
    private static final int SEEDS = 24;
    private static final int POURING_SECONDS = 20;

    private static final int CROWD = 100_000;
    private static final int CROWD_STEPS = 240;

    @ParameterizedTest
    @ValueSource(strings = {"benchmark", "mirrors", "teaching", "spheres-100", "spheres-10000", "pour-1000"})
    void movesAsItShouldAndComesToRestForGood(String name) {
        Scene scene = SceneReader.read(Path.of("scenes", name + ".json"));
        double height = scene.ground().height();
        try (Simulation simulation = Simulation.of(scene)) {
            double most = 0;
            float[] resting = {};
            long restSeconds = 0;
            for (long second = 0; second < SECONDS; second++) {
                most = Motion.runWithoutGain(simulation, STEPS_A_SECOND, height, most, MOST_GAIN);
                keepsWithinItsBounds(simulation, scene.ground().size() / 2, height);
                float[] now = simulation.positions();
                if (Motion.sleepers(simulation) == simulation.store().count - 1) {
                    assertThat(deepestOverlap(simulation)).isLessThan(DEEPEST_AT_REST);
                    if (restSeconds > 0) {
                        assertThat(now).containsExactly(resting);
                    }
                    resting = now;
                    restSeconds++;
                } else {
                    assertThat(restSeconds)
                            .as("seconds at rest before bodies moved again")
                            .isZero();
                    assertThat(deepestOverlap(simulation)).isLessThan(DEEPEST);
                }
            }
            assertThat(restSeconds).isGreaterThan(SECONDS / 4);
        }
    }

    @Test
    void noPourOfAThousandGainsEnergy() {
        for (int seed = FIRST_SEED; seed < FIRST_SEED + SEEDS; seed++) {
            try (Simulation simulation = Simulation.of(Motion.pourOfAThousand(seed))) {
                Motion.runWithoutGain(simulation, POURING_SECONDS * STEPS_A_SECOND, 0, 0, MOST_GAIN);
            }
        }
    }

    @Test
    void aHundredThousandMoveAlikeOnOneThreadAndOnTwo() {
        Scene scene = SceneGenerator.spheres(CROWD, 5, Path.of("skyboxes", "day.hdr"));
        try (Simulation one = Simulation.of(scene, SceneMeshes.NONE, 1);
                Simulation two = Simulation.of(scene, SceneMeshes.NONE, 2)) {
            float[] start = one.positions();
            Motion.run(one, CROWD_STEPS * Simulation.STEP_SECONDS);
            Motion.run(two, CROWD_STEPS * Simulation.STEP_SECONDS);
            assertThat(one.store().numbers).isEqualTo(two.store().numbers);
            assertThat(Arrays.mismatch(one.positions(), two.positions())).isNegative();
            assertThat(Arrays.mismatch(one.positions(), start)).isNotNegative();
        }
    }

    private static void keepsWithinItsBounds(Simulation simulation, double halfSide, double height) {
        BodyStore bodies = simulation.store();
        for (int body = 1; body < bodies.count; body++) {
            double least = (1 - DEEPEST_IN_SURFACES) * Motion.radius(simulation, body);
            if (bodies.walled[body]) {
                assertThat(Math.abs(Motion.place(simulation, body, 0))).isLessThan(halfSide - least);
                assertThat(Math.abs(Motion.place(simulation, body, 2))).isLessThan(halfSide - least);
                assertThat(Motion.place(simulation, body, 1)).isGreaterThan(height + least);
            }
        }
    }

    /** As {@link Motion#deepestOverlap}, for many spheres: sorts them along x. */
    private static double deepestOverlap(Simulation simulation) {
        BodyStore bodies = simulation.store();
        Integer[] order = new Integer[bodies.count - 1];
        Arrays.setAll(order, index -> index + 1);
        Arrays.sort(order, Comparator.comparingDouble(body -> least(simulation, body)));
        double deepest = Double.NEGATIVE_INFINITY;
        for (int one = 0; one < order.length; one++) {
            double end = Motion.place(simulation, order[one], 0) + Motion.radius(simulation, order[one]);
            for (int other = one + 1; other < order.length && least(simulation, order[other]) < end; other++) {
                deepest = Math.max(deepest, Motion.overlap(simulation, order[one], order[other]));
            }
        }
        return deepest;
    }

    private static double least(Simulation simulation, int body) {
        return Motion.place(simulation, body, 0) - Motion.radius(simulation, body);
    }
}
