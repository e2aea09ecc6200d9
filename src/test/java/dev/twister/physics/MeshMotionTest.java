package dev.twister.physics;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import dev.twister.scene.Physics;
import dev.twister.scene.Scene;
import dev.twister.scene.Sphere;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Spheres on triangles; the plane is far below. */
class MeshMotionTest {
    private static final double RADIUS = 0.5;

    @ParameterizedTest
    @ValueSource(doubles = {1, 0.7, 0.5})
    void bouncesAsOnThePlane(double elasticity) {
        double height = 3;
        Physics physics = Physics.DEFAULT.withElasticity(elasticity);
        // Above a triangle, an edge and a vertex.
        for (double place : new double[] {0.3, 0.5, 1}) {
            double[] onMesh = peaks(
                    physics, field(2, 1, 10), Motion.sphere(place, 10 + RADIUS + height, place, RADIUS), 10 + RADIUS);
            for (int bounce = 0; bounce < 3; bounce++) {
                assertThat(onMesh[bounce])
                        .isCloseTo(height * Math.pow(elasticity, 2 * (bounce + 1)), within(1e-6 * height));
            }
        }
    }

    private static double[] peaks(Physics physics, MeshCollider mesh, Sphere sphere, double ground) {
        double[] peaks = new double[3];
        int bounces = 0;
        try (Simulation simulation = Simulation.of(Motion.scene(physics, sphere), mesh, 1)) {
            double before = 0;
            for (int step = 0; bounces < peaks.length && step < 900; step++) {
                simulation.step();
                double velocity = simulation.velocity(1, 1);
                if (velocity > 0 && before <= 0) {
                    peaks[bounces++] =
                            Motion.place(simulation, 1, 1) - ground + velocity * velocity / 2 / Motion.GRAVITY;
                }
                before = velocity;
            }
        }
        return peaks;
    }

    @Test
    void slidesOverBordersWithoutStumbling() {
        Physics physics = Physics.DEFAULT.withFriction(0).withElasticity(1).withWalls(false);
        try (Simulation simulation = Simulation.of(
                Motion.scene(physics, Motion.sphere(-8, 10 + RADIUS, 0.1, RADIUS)), field(10, 1, 10), 1)) {
            Motion.setVelocity(simulation, 1, 4, 0, 0.3);
            for (int step = 0; step < 3 * 120; step++) {
                simulation.step();
                assertThat(Motion.place(simulation, 1, 1)).isCloseTo(10 + RADIUS, within(0.01));
            }
            assertThat(simulation.velocity(1, 0)).isCloseTo(4, within(1e-3));
            assertThat(simulation.velocity(1, 2)).isCloseTo(0.3, within(1e-3));
        }
    }

    @ParameterizedTest
    @ValueSource(doubles = {3, 30, 500})
    void nothingLeavesAClosedBox(double speed) {
        Random random = new Random(5);
        List<Sphere> spheres = new ArrayList<>();
        for (int i = 0; i < 40; i++) {
            spheres.add(
                    Motion.sphere(place(random), 20 + place(random), place(random), 0.05 + 0.1 * random.nextDouble()));
        }
        Physics physics = Physics.DEFAULT.withElasticity(0.9).withWalls(false);
        try (Simulation simulation = Simulation.of(Motion.scene(physics, 20, spheres), box(3, 20), 1)) {
            for (int body = 1; body <= spheres.size(); body++) {
                Motion.setVelocity(
                        simulation, body, speed * random.nextGaussian(), speed * random.nextGaussian(), speed);
            }
            for (int step = 0; step < 240; step++) {
                simulation.step();
                for (int body = 1; body <= spheres.size(); body++) {
                    assertThat(Math.abs(Motion.place(simulation, body, 0))).isLessThan(3);
                    assertThat(Math.abs(Motion.place(simulation, body, 1) - 20)).isLessThan(3);
                    assertThat(Math.abs(Motion.place(simulation, body, 2))).isLessThan(3);
                }
            }
        }
    }

    private static double place(Random random) {
        return 5 * random.nextDouble() - 2.5;
    }

    @Test
    void comesToRestInABowl() {
        List<Sphere> spheres = new ArrayList<>();
        for (int i = 0; i < 20; i++) {
            int row = i / 5;
            spheres.add(Motion.sphere(0.4 * (i % 5) - 0.8, 11 + 0.5 * row, 0.37 * row - 0.6, 0.15));
        }
        Scene scene = Motion.scene(Physics.DEFAULT, 20, spheres);
        try (Simulation simulation = Simulation.of(scene, bowl(2, 12), 1)) {
            Motion.run(simulation, 10);
            for (int body = 1; body <= spheres.size(); body++) {
                double x = Motion.place(simulation, body, 0);
                double y = Motion.place(simulation, body, 1) - 12;
                double z = Motion.place(simulation, body, 2);
                assertThat(Math.sqrt(x * x + y * y + z * z)).isLessThan(2);
            }
            assertThat(Motion.sleepers(simulation)).isEqualTo(spheres.size());
        }
    }

    /** A square field of (2 size)^2 cells with two triangles each. */
    private static MeshCollider field(int size, double side, double height) {
        List<double[]> triangles = new ArrayList<>();
        for (int column = -size; column < size; column++) {
            for (int row = -size; row < size; row++) {
                double x = column * side;
                double z = row * side;
                triangles.add(new double[] {x, height, z, x, height, z + side, x + side, height, z + side});
                triangles.add(new double[] {x, height, z, x + side, height, z + side, x + side, height, z});
            }
        }
        return surface(triangles);
    }

    private static MeshCollider box(double half, double height) {
        List<double[]> triangles = new ArrayList<>();
        for (int axis = 0; axis < 3; axis++) {
            for (int sign = -1; sign <= 1; sign += 2) {
                double[][] corners = new double[4][3];
                for (int corner = 0; corner < 4; corner++) {
                    corners[corner][axis] = sign * half;
                    corners[corner][(axis + 1) % 3] = corner % 2 == 0 ? -half : half;
                    corners[corner][(axis + 2) % 3] = corner / 2 == 0 ? -half : half;
                    corners[corner][1] += height;
                }
                triangles.add(triangle(corners[0], corners[1], corners[3]));
                triangles.add(triangle(corners[0], corners[3], corners[2]));
            }
        }
        return surface(triangles);
    }

    /** The lower half of a sphere. */
    private static MeshCollider bowl(double radius, double height) {
        int rings = 12;
        int sectors = 24;
        List<double[]> triangles = new ArrayList<>();
        for (int ring = 0; ring < rings; ring++) {
            for (int sector = 0; sector < sectors; sector++) {
                double[] a = onBowl(radius, height, ring, sector, rings, sectors);
                double[] b = onBowl(radius, height, ring + 1, sector, rings, sectors);
                double[] c = onBowl(radius, height, ring + 1, (sector + 1) % sectors, rings, sectors);
                double[] d = onBowl(radius, height, ring, (sector + 1) % sectors, rings, sectors);
                triangles.add(triangle(a, b, c));
                if (ring > 0) {
                    triangles.add(triangle(a, c, d));
                }
            }
        }
        return surface(triangles);
    }

    private static double[] onBowl(double radius, double height, int ring, int sector, int rings, int sectors) {
        double down = Math.PI / 2 * ring / rings;
        double around = 2 * Math.PI * sector / sectors;
        double across = ring == 0 ? 0 : radius * Math.sin(down);
        return new double[] {across * Math.cos(around), height - radius * Math.cos(down), across * Math.sin(around)};
    }

    private static double[] triangle(double[] a, double[] b, double[] c) {
        return new double[] {a[0], a[1], a[2], b[0], b[1], b[2], c[0], c[1], c[2]};
    }

    private static MeshCollider surface(List<double[]> triangles) {
        return new MeshCollider(
                triangles.stream().flatMapToDouble(java.util.Arrays::stream).toArray());
    }
}
