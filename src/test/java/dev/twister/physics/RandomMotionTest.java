package dev.twister.physics;

import static org.assertj.core.api.Assertions.assertThat;

import dev.twister.scene.Physics;
import dev.twister.scene.Scene;
import dev.twister.scene.Sphere;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.DoubleRange;
import net.jqwik.api.constraints.IntRange;

class RandomMotionTest {
    private static final String SEED = "20261121";

    /** Overlapping starts, any elasticity and friction, radius ratios up to 5: all spheres come to rest in the box. */
    @Property(tries = 25, seed = SEED)
    void whateverStartsEndsInOrder(
            @ForAll @IntRange(min = 1, max = 120) int count,
            @ForAll @DoubleRange(min = 0, max = 0.9) double elasticity,
            @ForAll @DoubleRange(min = 0, max = 1) double friction,
            @ForAll long seed) {
        Random random = new Random(seed);
        List<Sphere> spheres = new ArrayList<>();
        for (int i = 0; i < count; i++) {
            double radius = 0.1 + 0.4 * random.nextDouble();
            spheres.add(Motion.sphere(
                    6 * random.nextDouble() - 3, 0.5 + 4 * random.nextDouble(), 6 * random.nextDouble() - 3, radius));
        }
        Physics physics = Physics.DEFAULT.withElasticity(elasticity).withFriction(friction);
        try (Simulation simulation = Simulation.of(Motion.scene(physics, 8, spheres))) {
            for (int body = 1; body <= count; body++) {
                Motion.setVelocity(
                        simulation,
                        body,
                        random.nextGaussian() * 5,
                        random.nextGaussian() * 5,
                        random.nextGaussian() * 5);
            }
            for (int second = 0; second < 8; second++) {
                Motion.run(simulation, 1);
                for (int body = 1; body <= count; body++) {
                    double reach = 4 - 0.8 * Motion.radius(simulation, body);
                    assertThat(Math.abs(Motion.place(simulation, body, 0))).isLessThan(reach);
                    assertThat(Math.abs(Motion.place(simulation, body, 2))).isLessThan(reach);
                    assertThat(Motion.place(simulation, body, 1)).isBetween(0.0, 100.0);
                }
            }
            for (int body = 1; body <= count; body++) {
                assertThat(Motion.place(simulation, body, 1)).isGreaterThan(0.95 * Motion.radius(simulation, body));
            }
            assertThat(Motion.deepestOverlap(simulation)).isLessThan(0.05);
        }
    }

    /** The grid against testing all pairs, with radii over four orders of magnitude. */
    @Property(tries = 60, seed = SEED)
    void theGridFindsWhatTryingAllFinds(@ForAll @IntRange(min = 40, max = 300) int count, @ForAll long seed) {
        findsWhatTryingAllFinds(count, 1, seed);
    }

    /** Enough spheres that the broad phase compares several at once if the CPU has vectors. */
    @Property(tries = 3, seed = SEED)
    void theGridFindsThePairsOfMany(@ForAll @IntRange(min = 2600, max = 3000) int count, @ForAll long seed) {
        findsWhatTryingAllFinds(count, 3, seed);
    }

    private static void findsWhatTryingAllFinds(int count, double extent, long seed) {
        Random random = new Random(seed);
        List<Sphere> spheres = new ArrayList<>();
        for (int i = 0; i < count; i++) {
            double radius = 0.01 * Math.pow(10, 2.5 * random.nextDouble() * random.nextDouble());
            spheres.add(Motion.sphere(
                    extent * (3 * random.nextDouble() - 1.5),
                    extent * random.nextGaussian(),
                    extent * (3 * random.nextDouble() - 1.5),
                    radius));
        }
        Scene scene = Motion.scene(Physics.DEFAULT, 8 * extent, spheres);
        BodyStore bodies = new BodyStore(scene, spheres);
        spheres.forEach(sphere -> bodies.add(sphere.position(), sphere.radius()));
        for (int body = 1; body <= count; body += 3) {
            bodies.sleep(body);
        }
        try (Team team = new Team(1)) {
            ContactSearch search = new ContactSearch(bodies, Surroundings.of(scene, MeshCollider.EMPTY), team, 1, 0.05);
            search.search(new BodyPasses(bodies, team, 1).reach(0.1, 4, 0.001), false);
            List<String> found = new ArrayList<>();
            collect(search.giantsContacts(), found);
            for (int row = 0; row < search.columns().rows(); row++) {
                collect(search.contacts(row), found);
            }
            assertThat(found.stream().sorted())
                    .containsExactlyElementsOf(all(bodies).stream().sorted().toList());
        }
    }

    private static void collect(Contacts contacts, List<String> pairs) {
        for (int contact = 0; contact < contacts.count; contact++) {
            if (contacts.second[contact] >= 0) {
                pairs.add(name(contacts.first[contact], contacts.second[contact]));
            }
        }
    }

    private static List<String> all(BodyStore bodies) {
        List<String> pairs = new ArrayList<>();
        double[] n = bodies.numbers;
        for (int one = 1; one < bodies.count; one++) {
            for (int other = one + 1; other < bodies.count; other++) {
                int a = BodyStore.STRIDE * one;
                int b = BodyStore.STRIDE * other;
                double x = n[a] - n[b];
                double y = n[a + 1] - n[b + 1];
                double z = n[a + 2] - n[b + 2];
                double reach = bodies.reach[one] + bodies.reach[other];
                boolean asleep = bodies.state[one] == BodyStore.ASLEEP && bodies.state[other] == BodyStore.ASLEEP;
                if (!asleep && x * x + y * y + z * z <= reach * reach) {
                    pairs.add(name(one, other));
                }
            }
        }
        return pairs;
    }

    private static String name(int one, int other) {
        return Math.min(one, other) + "-" + Math.max(one, other);
    }
}
