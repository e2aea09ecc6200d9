package dev.twister.physics;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import dev.twister.scene.Physics;
import dev.twister.scene.Scene;
import org.junit.jupiter.api.Test;

class FreeFallTest {
    private static final double SECONDS = 2;

    @Test
    void fallsAsGalileoSays() {
        try (Simulation simulation = Simulation.of(Motion.scene(Physics.DEFAULT, Motion.sphere(1, 100, 2, 0.5)))) {
            Motion.run(simulation, SECONDS);

            assertThat(Motion.place(simulation, 1, 1))
                    .isCloseTo(100 - Motion.GRAVITY * SECONDS * SECONDS / 2, within(1e-9));
            assertThat(simulation.velocity(1, 1)).isCloseTo(-Motion.GRAVITY * SECONDS, within(1e-9));
            assertThat(Motion.place(simulation, 1, 0)).isEqualTo(1);
        }
    }

    @Test
    void fallsThroughAirWithSecondOrder() {
        double coarse = error(1.0 / 30);
        double middle = error(1.0 / 60);
        double fine = error(1.0 / 120);

        assertThat(Math.log(coarse / middle) / Math.log(2)).isBetween(1.95, 2.05);
        assertThat(Math.log(middle / fine) / Math.log(2)).isBetween(1.95, 2.05);
        assertThat(fine).isLessThan(2e-4);
    }

    // With drag c: v(t) = -g/c (1 - exp(-c t)), y(t) = y0 - g/c (t - (1 - exp(-c t)) / c).
    private static double error(double step) {
        double drag = 0.8;
        Scene scene = Motion.scene(Physics.DEFAULT.withDamping(drag), Motion.sphere(0, 100, 0, 0.5));
        BodyStore bodies = new BodyStore(scene, scene.spheres());
        Surroundings surroundings = Surroundings.of(scene, MeshCollider.EMPTY);
        VerletIntegrator integrator = new VerletIntegrator(bodies, surroundings);
        integrator.setSubstep(step);
        bodies.add(scene.spheres().getFirst().position(), 0.5);
        bodies.setMove(1, 0, integrator.moveBefore(0, -Motion.GRAVITY), 0);
        for (long left = Math.round(SECONDS / step); left > 0; left--) {
            integrator.accelerate(1, 2);
            integrator.move(1, 2);
        }
        double lag = (1 - Math.exp(-drag * SECONDS)) / drag;
        double exact = 100 - Motion.GRAVITY / drag * (SECONDS - lag);
        return Math.abs(bodies.numbers[BodyStore.STRIDE + BodyStore.POSITION + 1] - exact);
    }
}
