package dev.twister.physics;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import dev.twister.scene.Light;
import dev.twister.scene.Physics;
import dev.twister.scene.Rgb;
import dev.twister.scene.Scene;
import dev.twister.scene.Sphere;
import dev.twister.scene.Vector3;
import dev.twister.scene.generate.Pour;
import dev.twister.scene.light.Lights;
import dev.twister.world.SceneMeshes;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.function.UnaryOperator;
import org.junit.jupiter.api.Test;

/** Scenes that are edited while their bodies move. */
class EditedMotionTest {
    private static final double SMALLEST_RADIUS = 0.07;
    private static final Pour POUR = Pour.DEFAULT
            .withCount(400)
            .withRate(400)
            .withPosition(new Vector3(0, 3, 0))
            .withWidth(1.6)
            .withSpeed(3)
            .withRadii(SMALLEST_RADIUS, 0.13);
    private static final Scene FALLING = Motion.scene(
            Physics.DEFAULT, Motion.sphere(-3, 8, 0, 0.5), Motion.sphere(0, 9, 0, 0.5), Motion.sphere(3, 10, 0, 0.5));
    private static final double SECONDS = 0.5;
    private static final double SPEED = Motion.GRAVITY * SECONDS;

    /** Simulates half a second before and after the edit, or a whole second at once without an edit. */
    private static float[] positions(Scene scene, UnaryOperator<Scene> edit) {
        Simulation simulation = Simulation.of(scene, SceneMeshes.NONE, 2);
        Motion.run(simulation, SECONDS);
        Simulation next = simulation.goOnIn(edit.apply(scene), SceneMeshes.NONE);
        Motion.run(next, SECONDS);
        float[] positions = next.positions();
        next.close();
        return positions;
    }

    private static List<Sphere> recolored(List<Sphere> spheres) {
        return spheres.stream()
                .map(sphere -> sphere.withColor(new Rgb(0.1, 0.5, 0.9)).withReflectivity(128))
                .toList();
    }

    @Test
    void colorReflectivityAndTheLightMoveNothing() {
        Scene poured = FALLING.withPour(POUR);
        float[] unedited = positions(poured, scene -> scene);
        float[] edited = positions(
                poured,
                scene -> scene.withSpheres(recolored(scene.spheres()))
                        .withLights(Lights.of(Light.of(new Vector3(1, 2, 3), 0.5, new Rgb(1, 0, 0)))));
        assertThat(edited).startsWith(1, 2, 3);
        System.arraycopy(unedited, 0, edited, 0, 3);
        assertThat(edited).containsExactly(unedited);
    }

    @Test
    void anotherGravityKeepsPlacesAndSpeeds() {
        Simulation simulation = Simulation.of(FALLING);
        Motion.run(simulation, SECONDS);
        double height = Motion.place(simulation, 1, 1);
        try (Simulation next = simulation.goOnIn(FALLING.withPhysics(Motion.WEIGHTLESS), SceneMeshes.NONE)) {
            assertThat(Motion.place(next, 1, 1)).isEqualTo(height);
            assertThat(next.velocity(1, 1)).isCloseTo(-SPEED, within(1e-9));
            Motion.run(next, 0.25);
            assertThat(Motion.place(next, 1, 1)).isCloseTo(height - SPEED * 0.25, within(1e-6));
        }
    }

    @Test
    void oneDeletedAndOneInsertedAtOnceLeaveTheOthersFalling() {
        Simulation simulation = Simulation.of(FALLING);
        Motion.run(simulation, SECONDS);
        double height = Motion.place(simulation, 2, 1);
        List<Sphere> spheres = new ArrayList<>(FALLING.spheres());
        spheres.remove(0);
        spheres.add(Motion.sphere(6, 5, 0, 0.5));
        try (Simulation next = simulation.goOnIn(FALLING.withSpheres(spheres), SceneMeshes.NONE)) {
            assertThat(Motion.place(next, 1, 1)).isEqualTo(height);
            assertThat(next.velocity(1, 1)).isCloseTo(-SPEED, within(1e-9));
            assertThat(Motion.place(next, 3, 1)).isEqualTo(5);
            assertThat(next.velocity(3, 1)).isZero();
        }
    }

    @Test
    void thePouredGoOnFallingAndComing() {
        Scene scene = FALLING.withPour(POUR);
        Simulation simulation = Simulation.of(scene);
        Motion.run(simulation, SECONDS);
        int there = simulation.bodies();
        float[] before = simulation.positions();
        try (Simulation next = simulation.goOnIn(
                scene.withPhysics(Physics.DEFAULT.withGravity(new Vector3(0, -3, 0))), SceneMeshes.NONE)) {
            assertThat(there).isGreaterThan(200);
            assertThat(next.bodies()).isEqualTo(there);
            assertThat(next.positions()).startsWith(before);
            assertThat(next.seconds()).isEqualTo(SECONDS);
            Motion.run(next, 0.1);
            assertThat(next.bodies()).isEqualTo(there + 40);
        }
    }

    @Test
    void aSphereThatIsPutElsewhereStartsThereAtRestAndTheOthersGoOn() {
        List<Sphere> spheres = new ArrayList<>(FALLING.spheres());
        spheres.set(1, Motion.sphere(0, 5, 2, 0.5));
        Simulation simulation = Simulation.of(FALLING);
        Motion.run(simulation, SECONDS);
        try (Simulation next = simulation.goOnIn(FALLING.withSpheres(spheres), SceneMeshes.NONE)) {
            assertThat(Motion.place(next, 2, 1)).isEqualTo(5);
            assertThat(Motion.speed(next, 2)).isZero();
            assertThat(next.velocity(1, 1)).isCloseTo(-SPEED, within(1e-9));
            assertThat(next.velocity(3, 1)).isCloseTo(-SPEED, within(1e-9));
        }
    }

    @Test
    void spheresComeAndGoAndTheOthersGoOn() {
        Scene scene = FALLING.withPour(POUR);
        Simulation simulation = Simulation.of(scene);
        Motion.run(simulation, SECONDS);
        double third = Motion.place(simulation, 3, 1);
        double poured = Motion.place(simulation, 4, 1);
        Scene without = scene.withSpheres(
                List.of(scene.spheres().get(0), scene.spheres().get(2)));
        Simulation fewer = simulation.goOnIn(without, SceneMeshes.NONE);
        assertThat(Motion.place(fewer, 2, 1)).isEqualTo(third);
        assertThat(Motion.place(fewer, 3, 1)).isEqualTo(poured);
        try (Simulation more = fewer.goOnIn(scene, SceneMeshes.NONE)) {
            assertThat(Motion.place(more, 2, 1)).isEqualTo(9);
            assertThat(Motion.place(more, 3, 1)).isEqualTo(third);
            assertThat(more.velocity(3, 1)).isCloseTo(-SPEED, within(1e-9));
            assertThat(Motion.place(more, 4, 1)).isEqualTo(poured);
        }
    }

    @Test
    void aPileThatRestsStaysWhereItIsUnderAnotherGravity() {
        Scene scene = Motion.scene(Physics.DEFAULT, 8, List.of()).withPour(POUR);
        Simulation simulation = Simulation.of(scene);
        Motion.run(simulation, 6);
        float[] before = simulation.positions();
        try (Simulation next = simulation.goOnIn(
                scene.withPhysics(Physics.DEFAULT.withGravity(new Vector3(0, -9, 0))), SceneMeshes.NONE)) {
            double farthest = 0;
            Set<Integer> moved = new HashSet<>();
            for (int step = 0; step < 120; step++) {
                next.step();
                float[] now = next.positions();
                for (int i = 0; i < now.length; i++) {
                    double distance = Math.abs(now[i] - before[i]);
                    farthest = Math.max(farthest, distance);
                    if (distance > SMALLEST_RADIUS / 10) {
                        moved.add(i / 3);
                    }
                }
            }
            // A sphere on the brink may roll into its neighbor.
            assertThat(moved).hasSizeLessThanOrEqualTo(2);
            assertThat(farthest).isPositive().isLessThan(SMALLEST_RADIUS / 2);
        }
    }
}
