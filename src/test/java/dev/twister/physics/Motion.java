package dev.twister.physics;

import static org.assertj.core.api.Assertions.assertThat;

import dev.twister.scene.Camera;
import dev.twister.scene.Ground;
import dev.twister.scene.Light;
import dev.twister.scene.Physics;
import dev.twister.scene.Rgb;
import dev.twister.scene.Scene;
import dev.twister.scene.Shading;
import dev.twister.scene.Sphere;
import dev.twister.scene.Vector3;
import dev.twister.scene.format.SceneReader;
import dev.twister.scene.generate.Pour;
import dev.twister.scene.light.Lights;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;

/** Scenes in motion and measurements of them; bodies are numbered from 1 in scene order. */
final class Motion {
    static final double GRAVITY = 9.81;
    static final Physics WEIGHTLESS = Physics.DEFAULT
            .withGravity(new Vector3(0, 0, 0))
            .withElasticity(1)
            .withFriction(0)
            .withWalls(false);

    private Motion() {}

    static Scene scene(Physics physics, double planeSize, List<Sphere> spheres) {
        Rgb white = new Rgb(1, 1, 1);
        return Scene.under(Path.of("none.hdr"))
                .withCamera(Camera.of(new Vector3(0, 5, -15), 0, 7, 50))
                .withLights(Lights.of(Light.of(new Vector3(0, 50, 0), 1, white)))
                .withGround(Ground.of(planeSize, 0, white, white, 32))
                .withSpheres(spheres)
                .withShading(new Shading(0.2))
                .withPhysics(physics);
    }

    static Scene scene(Physics physics, Sphere... spheres) {
        return scene(physics, 20, Arrays.asList(spheres));
    }

    static Sphere sphere(double x, double y, double z, double radius) {
        return Sphere.of(new Vector3(x, y, z), radius, new Rgb(1, 1, 1), 8);
    }

    static void setVelocity(Simulation simulation, int body, double x, double y, double z) {
        double substep = Simulation.STEP_SECONDS / Simulation.SUBSTEPS;
        simulation.store().setMove(body, x * substep, y * substep, z * substep);
    }

    static void run(Simulation simulation, double seconds) {
        for (long step = Math.round(seconds / Simulation.STEP_SECONDS); step > 0; step--) {
            simulation.step();
        }
    }

    static double place(Simulation simulation, int body, int axis) {
        return simulation.store().numbers[BodyStore.STRIDE * body + BodyStore.POSITION + axis];
    }

    static double radius(Simulation simulation, int body) {
        return simulation.store().numbers[BodyStore.STRIDE * body + BodyStore.RADIUS];
    }

    static double mass(Simulation simulation, int body) {
        return 1 / simulation.store().inverseMass(radius(simulation, body));
    }

    static double speed(Simulation simulation, int body) {
        if (simulation.store().state[body] == BodyStore.ASLEEP) {
            return 0;
        }
        double x = simulation.velocity(body, 0);
        double y = simulation.velocity(body, 1);
        double z = simulation.velocity(body, 2);
        return Math.sqrt(x * x + y * y + z * z);
    }

    /** Kinetic and potential energy above the plane, in units of the largest sphere's mass times m^2/s^2. */
    static double energy(Simulation simulation) {
        double energy = 0;
        for (int body = 1; body < simulation.store().count; body++) {
            energy += energy(simulation, body);
        }
        return energy;
    }

    /** One body's share of {@link #energy(Simulation)}. */
    static double energy(Simulation simulation, int body) {
        double speed = speed(simulation, body);
        return mass(simulation, body) * (speed * speed / 2 + GRAVITY * place(simulation, body, 1));
    }

    /**
     * Energies of single spheres above {@code height}, in scene order, so that reordering of bodies changes nothing.
     */
    static double[] energies(Simulation simulation, double height) {
        BodyStore bodies = simulation.store();
        double[] energies = new double[bodies.count - 1];
        for (int body = 1; body < bodies.count; body++) {
            double lift = GRAVITY * height * mass(simulation, body);
            energies[bodies.sphere[body]] = energy(simulation, body) - lift;
        }
        return energies;
    }

    /**
     * Runs steps and checks after each that the energy does not exceed the maximum so far plus that of new spheres.
     *
     * @param mostGain allowed gain per step, as a fraction of the maximum energy so far
     * @return the maximum energy so far
     */
    static double runWithoutGain(Simulation simulation, int steps, double height, double mostSoFar, double mostGain) {
        double most = mostSoFar;
        double[] before = energies(simulation, height);
        for (int step = 0; step < steps; step++) {
            simulation.step();
            double[] now = energies(simulation, height);
            double sum = sum(before, 0) + sum(now, before.length);
            most = Math.max(most, sum);
            assertThat(sum(now, 0))
                    .as("energy at %.3f s", simulation.seconds())
                    .isFinite()
                    .isLessThanOrEqualTo(sum + mostGain * most);
            before = now;
        }
        return most;
    }

    /** The scene that pours a thousand spheres, in another order and with other sizes. */
    static Scene pourOfAThousand(int seed) {
        Scene scene = SceneReader.read(Path.of("scenes", "pour-1000.json"));
        Pour pour = scene.pour().orElseThrow();
        return scene.withPour(pour.withSeed(seed));
    }

    private static double sum(double[] energies, int from) {
        return Arrays.stream(energies, from, energies.length).sum();
    }

    /** Penetration of two spheres as a fraction of the sum of their radii; negative if apart. */
    static double overlap(Simulation simulation, int one, int other) {
        double x = place(simulation, one, 0) - place(simulation, other, 0);
        double y = place(simulation, one, 1) - place(simulation, other, 1);
        double z = place(simulation, one, 2) - place(simulation, other, 2);
        double radii = radius(simulation, one) + radius(simulation, other);
        return 1 - Math.sqrt(x * x + y * y + z * z) / radii;
    }

    static double deepestOverlap(Simulation simulation) {
        double deepest = Double.NEGATIVE_INFINITY;
        for (int one = 1; one < simulation.store().count; one++) {
            for (int other = one + 1; other < simulation.store().count; other++) {
                deepest = Math.max(deepest, overlap(simulation, one, other));
            }
        }
        return deepest;
    }

    static int sleepers(Simulation simulation) {
        int sleepers = 0;
        for (int body = 1; body < simulation.store().count; body++) {
            sleepers += simulation.store().state[body] == BodyStore.ASLEEP ? 1 : 0;
        }
        return sleepers;
    }
}
