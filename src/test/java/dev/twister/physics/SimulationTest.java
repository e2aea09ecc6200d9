package dev.twister.physics;

import static org.assertj.core.api.Assertions.assertThat;

import dev.twister.scene.Physics;
import dev.twister.scene.Scene;
import dev.twister.scene.Sphere;
import dev.twister.scene.Vector3;
import dev.twister.scene.generate.Pour;
import dev.twister.sky.Skybox;
import dev.twister.world.FrameInput;
import dev.twister.world.Positions;
import dev.twister.world.SceneMeshes;
import dev.twister.world.World;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.atomic.AtomicInteger;
import org.junit.jupiter.api.Test;

class SimulationTest {
    private static final Pour POUR = Pour.DEFAULT
            .withCount(3000)
            .withRate(1500)
            .withPosition(new Vector3(0, 3, 0))
            .withWidth(3.5)
            .withSpeed(3)
            .withRadii(0.07, 0.13);

    @Test
    void theSameBitsOnEveryRunAndForEveryNumberOfThreads() {
        float[] one = poured(1);
        assertThat(poured(1)).containsExactly(one);
        assertThat(poured(2)).containsExactly(one);
        assertThat(poured(3)).containsExactly(one);
    }

    private static float[] poured(int threads) {
        List<Sphere> spheres = new ArrayList<>();
        spheres.add(Motion.sphere(0.3, 1, 0, 1));
        Scene scene = Motion.scene(Physics.DEFAULT, 9, spheres).withPour(POUR);
        try (Simulation simulation = Simulation.of(scene, SceneMeshes.NONE, threads)) {
            Motion.run(simulation, 2.5);
            return simulation.positions();
        }
    }

    @Test
    void framesDoNotChangeTheSteps() {
        Scene scene = Motion.scene(Physics.DEFAULT, Motion.sphere(0, 3, 0, 0.5));
        try (Simulation film = Simulation.of(scene);
                Simulation television = Simulation.of(scene)) {
            for (int frame = 0; frame < 24; frame++) {
                film.advance(1.0 / 24);
            }
            for (int frame = 0; frame < 50; frame++) {
                television.advance(1.0 / 50);
            }
            assertThat(film.seconds()).isEqualTo(television.seconds()).isEqualTo(1);
            assertThat(film.positions()).containsExactly(television.positions());
        }
    }

    @Test
    void betweenStepsBodiesAreBetweenTheirPlaces() {
        try (Simulation simulation = Simulation.of(Motion.scene(Motion.WEIGHTLESS, Motion.sphere(0, 3, 0, 0.5)))) {
            Motion.setVelocity(simulation, 1, 12, 0, 0);
            simulation.advance(Simulation.STEP_SECONDS * 2.25);
            assertThat(simulation.seconds()).isEqualTo(2 * Simulation.STEP_SECONDS);
            // A quarter of the way from the end of one step to the end of the next.
            assertThat(simulation.positions()).containsExactly(0, 50, 0, 0, 0, 0, 0.125f, 3, 0);
        }
    }

    @Test
    void positionsAreANewArrayThatAWorldTakes() {
        Scene scene = Motion.scene(Physics.DEFAULT, Motion.sphere(1, 3, 2, 0.5));
        World world = World.of(scene, new Skybox(2, 1, new float[6]));
        float[] start = Positions.of(world.snapshot());
        try (Simulation simulation = Simulation.of(scene)) {
            assertThat(simulation.positions()).containsExactly(start).isNotSameAs(simulation.positions());
            simulation.advance(0.5);
            simulation.place(world);
            FrameInput moved = world.snapshot();
            assertThat(moved.bodyCount()).isEqualTo(3);
            assertThat(moved.bodies().floats()[9]).isLessThan(3).isGreaterThan(0.5f);
        }
    }

    @Test
    void whatIsPouredComesAtItsTime() {
        Scene scene = Motion.scene(Physics.DEFAULT, 9, List.of(Motion.sphere(0, 1, 0, 1)))
                .withPour(POUR);
        try (Simulation simulation = Simulation.of(scene, SceneMeshes.NONE, 1)) {
            assertThat(simulation.bodies()).isEqualTo(3);
            Motion.run(simulation, 0.1);
            assertThat(simulation.bodies()).isEqualTo(3 + 150);
            Motion.run(simulation, 2.1);
            assertThat(simulation.bodies()).isEqualTo(3 + 3000);
        }
    }

    @Test
    void tellsOfEachStep() {
        AtomicInteger steps = new AtomicInteger();
        try (Simulation simulation = Simulation.of(Motion.scene(Physics.DEFAULT))) {
            simulation.advance(0.5, steps::incrementAndGet);
        }
        assertThat(steps).hasValue(60);
    }

    @Test
    void aSceneWithoutSpheresStandsStill() {
        try (Simulation simulation = Simulation.of(Motion.scene(Physics.DEFAULT))) {
            simulation.advance(1);
            assertThat(simulation.positions()).containsExactly(0, 50, 0, 0, 0, 0);
        }
    }
}
