package dev.twister.physics;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import dev.twister.mesh.gltf.AnimatedGltf;
import dev.twister.scene.Easing;
import dev.twister.scene.Keyframe;
import dev.twister.scene.Mesh;
import dev.twister.scene.MeshAnimation;
import dev.twister.scene.Physics;
import dev.twister.scene.Scene;
import dev.twister.scene.Shape;
import dev.twister.scene.Sphere;
import dev.twister.scene.Track;
import dev.twister.scene.TrackTarget;
import dev.twister.scene.Vector3;
import dev.twister.world.SceneMeshes;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Spheres and a box that moves by a track; the plane is far below. */
class MovingMeshTest {
    private static final double RADIUS = 0.5;

    /** On a platform that rises by 2 m/s for 2 s, then stops. */
    @Test
    void aPlatformCarriesWhatIsOnIt() {
        Scene scene = scene(Physics.DEFAULT, new Vector3(0, 20, 0), new Vector3(0, 24, 0), 2, above(20.5));
        try (Simulation simulation = film(scene, 0)) {
            for (int step = 1; step <= 360; step++) {
                simulation.step();
                double top = 20.5 + Math.min(step, 240) / 60.0;
                double height = Motion.place(simulation, 1, 1) - top;
                // Thrown up a little where the platform starts and stops.
                assertThat(height).isGreaterThan(RADIUS - 0.05);
                if (step > 60 && step < 240) {
                    assertThat(height).isLessThan(RADIUS + 0.01);
                    assertThat(simulation.velocity(1, 1)).isCloseTo(2, within(0.02));
                }
            }
        }
    }

    @Test
    void frictionTakesSpheresAlong() {
        Physics physics = Physics.DEFAULT.withFriction(1);
        Scene scene = scene(physics, new Vector3(-3, 20, 0), new Vector3(3, 20, 0), 3, above(20.5));
        try (Simulation simulation = film(scene, 0)) {
            Motion.run(simulation, 2);

            assertThat(simulation.velocity(1, 0)).isCloseTo(2, within(0.02));
        }
    }

    /** A wall that is much heavier than what it hits, at 3 m/s. */
    @ParameterizedTest
    @ValueSource(doubles = {1, 0.5, 0})
    void aMovingWallThrowsBack(double elasticity) {
        Physics physics = Motion.WEIGHTLESS.withElasticity(elasticity);
        Scene scene =
                scene(physics, new Vector3(-3, 20, 0), new Vector3(0, 20, 0), 1, Motion.sphere(0, 20.1, 0.07, RADIUS));
        try (Simulation simulation = film(scene, 0)) {
            Motion.run(simulation, 1);

            assertThat(simulation.velocity(1, 0)).isCloseTo(3 * (1 + elasticity), within(0.03));
        }
    }

    /** At up to 400 m/s: 3 m a step, three times the box. */
    @ParameterizedTest
    @ValueSource(doubles = {10, 100, 400})
    void nothingIsInsideAfterAFastWall(double speed) {
        List<Sphere> spheres = new ArrayList<>();
        Random random = new Random(3);
        for (int i = 0; i < 30; i++) {
            spheres.add(Motion.sphere(0.6 + 0.25 * i, 20 + 0.3 * random.nextDouble(), 0.2 * random.nextDouble(), 0.1));
        }
        Scene scene = scene(
                Motion.WEIGHTLESS,
                new Vector3(-1, 20, 0),
                new Vector3(7, 20, 0),
                8 / speed,
                spheres.toArray(Sphere[]::new));
        try (Simulation simulation = film(scene, 0)) {
            Motion.run(simulation, 1);
            for (int body = 1; body <= spheres.size(); body++) {
                double x = Motion.place(simulation, body, 0) - 7;
                double y = Motion.place(simulation, body, 1) - 20;
                double z = Motion.place(simulation, body, 2);
                assertThat(Math.max(Math.abs(x), Math.max(Math.abs(y), Math.abs(z))))
                        .as("sphere %d", body)
                        .isGreaterThan(0.5);
            }
        }
    }

    /** A triangle across z that its file's animation moves by 4 m/s along z, past a sphere on one of its sides. */
    @Test
    void animationsOfFilesMoveTriangles(@TempDir Path folder) throws IOException {
        AnimatedGltf gltf = new AnimatedGltf();
        int times = gltf.accessor("SCALAR", 0, 1);
        int places = gltf.accessor("VEC3", 0, 0, 0, 0, 0, 4);
        Path file = folder.resolve("wall.gltf");
        Files.writeString(
                file, gltf.channel(0, "translation", "LINEAR", times, places).text(""));
        Mesh wall = Mesh.of(file).withPosition(new Vector3(0, 20, 0)).withAnimation(MeshAnimation.of("move"));
        Scene scene = Motion.scene(
                        Motion.WEIGHTLESS, Motion.sphere(0.25, 20.25, 1, 0.1), Motion.sphere(0.25, 20.25, -1, 0.1))
                .withMeshes(List.of(wall));
        try (Simulation simulation = film(scene, 0)) {
            Motion.run(simulation, 0.5);

            assertThat(List.of(simulation.velocity(1, 2), Math.abs(simulation.velocity(2, 2))))
                    .satisfiesExactlyInAnyOrder(
                            hit -> assertThat(Math.abs(hit)).isCloseTo(8, within(0.05)),
                            missed -> assertThat(missed).isZero());
        }
    }

    @Test
    void sleepersWakeWhenTheirGroundMoves() {
        Scene scene = scene(Physics.DEFAULT, new Vector3(0, 20, 0), new Vector3(0, 21, 0), 1, above(20.5));
        try (Simulation simulation = film(scene, 3)) {
            Motion.run(simulation, 3);
            assertThat(Motion.sleepers(simulation)).isOne();
            Motion.run(simulation, 3);

            assertThat(Motion.place(simulation, 1, 1)).isCloseTo(21.5 + RADIUS, within(0.02));
            assertThat(Motion.sleepers(simulation)).isOne();
        }
    }

    @Test
    void isTheSameWithAnyNumberOfThreads() {
        List<Sphere> spheres = new ArrayList<>();
        for (int i = 0; i < 3000; i++) {
            spheres.add(
                    Motion.sphere(0.3 * (i % 20) - 3, 21 + 0.3 * Math.floorDiv(i, 400), 0.3 * (i / 20 % 20) - 3, 0.1));
        }
        Scene scene = scene(
                Physics.DEFAULT, new Vector3(0, 20, 0), new Vector3(0.5, 20.5, 0), 0.5, spheres.toArray(Sphere[]::new));
        float[] one = after(scene, 1);

        assertThat(after(scene, 3)).isEqualTo(one);
        assertThat(one).isNotEqualTo(positions(Simulation.of(scene, SceneMeshes.read(scene, _ -> {}))));
    }

    private static float[] after(Scene scene, int threads) {
        MeshCollider mesh = MeshCollider.ofFilm(scene, SceneMeshes.read(scene, _ -> {}));
        return positions(Simulation.of(scene, mesh, threads));
    }

    private static float[] positions(Simulation simulation) {
        try (simulation) {
            Motion.run(simulation, 0.7);
            return simulation.positions();
        }
    }

    private static Sphere above(double top) {
        return Motion.sphere(0.1, top + RADIUS, 0.1, RADIUS);
    }

    private static Simulation film(Scene scene, double start) {
        return Simulation.ofFilm(scene, SceneMeshes.read(scene, _ -> {}), start);
    }

    /** A box that moves evenly: of side 1, or 12 long and deep under spheres on top. */
    private static Scene scene(Physics physics, Vector3 from, Vector3 to, double seconds, Sphere... spheres) {
        double side = spheres[0].position().y() > 20.5 ? 12 : 1;
        Mesh box =
                Mesh.of(new Shape(Shape.Kind.BOX, new Vector3(side, 1, side))).withPosition(from);
        Track track = Track.of(
                TrackTarget.mesh(0),
                "position",
                Keyframe.of(0, from).withEasing(Easing.LINEAR),
                Keyframe.of(seconds, to));
        return Motion.scene(physics.withWalls(false), 20, Arrays.asList(spheres))
                .withMeshes(List.of(box))
                .withTracks(List.of(track));
    }
}
