package dev.twister.physics;

import static org.assertj.core.api.Assertions.assertThat;

import dev.twister.scene.Physics;
import dev.twister.scene.Scene;
import dev.twister.scene.Sphere;
import dev.twister.scene.Vector3;
import dev.twister.scene.generate.Pour;
import java.util.List;
import org.junit.jupiter.api.Test;

/** Small spheres below and beside ones with thousands of times their mass. */
class HeavySphereTest {
    private static final int POURED = 4000;

    /** Upper bound of speeds in m/s; by now nothing is falling faster. */
    private static final double TOP_SPEED = 4;

    @Test
    void aHeavySphereShootsNoSmallOneAway() {
        List<Sphere> heavy = List.of(Motion.sphere(-1.2, 2, 0.6, 2), Motion.sphere(2.2, 1.6, -1.4, 1.6));
        Pour pour = Pour.DEFAULT
                .withCount(POURED)
                .withRate(2000)
                .withPosition(new Vector3(0, 5, 0))
                .withWidth(3)
                .withSpeed(3)
                .withRadii(0.1, 0.16)
                .withSeed(2);
        Physics physics = Physics.DEFAULT.withElasticity(0.3).withFriction(0.2);
        Scene scene = Motion.scene(physics, 8, heavy).withPour(pour);
        try (Simulation simulation = Simulation.of(scene)) {
            Motion.run(simulation, 6);
            double fastest = 0;
            for (int step = 0; step < 600; step++) {
                simulation.step();
                for (int body = 1; body <= heavy.size() + POURED; body++) {
                    fastest = Math.max(fastest, Motion.speed(simulation, body));
                }
            }
            assertThat(fastest).isLessThan(TOP_SPEED);
        }
    }
}
