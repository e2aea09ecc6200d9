package dev.twister.physics;

import static org.assertj.core.api.Assertions.assertThat;

import dev.twister.ChildJvm;
import dev.twister.scene.Physics;
import dev.twister.scene.Sphere;
import dev.twister.world.SceneMeshes;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

/** A JVM started without the Vector API simulates motion as well. */
class WithoutVectorsTest {
    @Test
    void manySpheresMove() throws IOException, InterruptedException {
        Process java = ChildJvm.start(ChildJvm.of(MotionMain.class).redirectErrorStream(true));
        String output = new String(java.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
        assertThat(java.waitFor()).as(output).isZero();
        assertThat(output).contains("fell");
    }

    /** Simulates more falling spheres than the scalar broad phase handles. */
    static final class MotionMain {
        private static final int SIDE = 60;

        private MotionMain() {}

        public static void main(String[] arguments) {
            List<Sphere> spheres = new ArrayList<>();
            for (int x = 0; x < SIDE; x++) {
                for (int z = 0; z < SIDE; z++) {
                    spheres.add(Motion.sphere(x, 2, z, 0.3));
                }
            }
            try (Simulation simulation =
                    Simulation.of(Motion.scene(Physics.DEFAULT, 200, spheres), SceneMeshes.NONE, 1)) {
                double before = Motion.place(simulation, 1, 1);
                Motion.run(simulation, 0.1);
                System.out.println(Motion.place(simulation, 1, 1) < before ? "fell" : "stayed");
            }
        }
    }
}
