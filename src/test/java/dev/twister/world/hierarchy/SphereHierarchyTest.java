package dev.twister.world.hierarchy;

import static org.assertj.core.api.Assertions.assertThat;

import dev.twister.kernel.Layout;
import dev.twister.world.RandomCrowds;
import java.util.Random;
import java.util.concurrent.ForkJoinPool;
import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import net.jqwik.api.ShrinkingMode;
import org.junit.jupiter.api.Test;

class SphereHierarchyTest {
    @Provide
    Arbitrary<RandomCrowds> crowds() {
        return Arbitraries.randomValue(random ->
                RandomCrowds.of(random, 1 + random.nextInt(random.nextInt(4) == 0 ? 9000 : 200)));
    }

    @Property(seed = "20261121", tries = 200, shrinking = ShrinkingMode.OFF)
    void everySphereIsInOneLeafInsideAllItsBoxes(@ForAll("crowds") RandomCrowds crowd) {
        int mostInLeaf = 1 + crowd.bodies() % 9;
        float[] hierarchy = SphereHierarchy.of(crowd.places(), crowd.bodies(), new int[0], mostInLeaf);
        Walk walk = new Walk(crowd, hierarchy, mostInLeaf);
        walk.visit(SphereHierarchy.root(crowd.bodies(), crowd.bodies(), 0), 0);
        assertThat(walk.visits).containsOnly(1).hasSize(crowd.bodies() - Layout.FIRST_SPHERE);
    }

    /** Independent of the number of threads that build it and of their order. */
    @Test
    void sameSpheresMakeTheSameHierarchy() {
        RandomCrowds crowd = RandomCrowds.of(new Random(5), 20_000);
        float[] first = SphereHierarchy.of(crowd.places(), crowd.bodies());
        for (int threads = 1; threads <= 5; threads++) {
            try (ForkJoinPool pool = new ForkJoinPool(threads)) {
                assertThat(pool.submit(() -> SphereHierarchy.of(crowd.places(), crowd.bodies()))
                                .join())
                        .isEqualTo(first);
            }
        }
    }

    /** Most spheres concentric, the others each twice as far out as the previous: no grid separates them. */
    @Test
    void crowdsThatNoGridTellsApartMakeNoDeeperHierarchy() {
        float[] places = new float[Layout.PLACE_STRIDE * 12_000];
        for (int body = Layout.FIRST_SPHERE; body < 12_000; body++) {
            int place = Layout.PLACE_STRIDE * body;
            places[place + body % 3] = body % 4 == 0 ? (float) Math.scalb(1.0, body % 83) : 0;
            places[place + Layout.PLACE_SIZE] = 0.5f;
        }
        requireSoundHierarchy(new RandomCrowds(places));
    }

    private static void requireSoundHierarchy(RandomCrowds crowd) {
        Walk walk = new Walk(crowd, SphereHierarchy.of(crowd.places(), crowd.bodies(), new int[0], 1), 1);
        walk.visit(SphereHierarchy.root(crowd.bodies(), crowd.bodies(), 0), 0);
        assertThat(walk.visits).containsOnly(1);
    }

    @Test
    void crowdsOfNextToNoWidthAreToldApartAsFarAsTheyCanBe() {
        float[] places = new float[Layout.PLACE_STRIDE * 5000];
        for (int body = Layout.FIRST_SPHERE; body < 5000; body++) {
            int place = Layout.PLACE_STRIDE * body;
            places[place] = body % 2 * 1e-40f;
            places[place + 1] = body % 7 * 1e-3f;
            places[place + 2] = 0.02f * (body % 100);
            places[place + Layout.PLACE_SIZE] = 0.1f;
        }
        requireSoundHierarchy(new RandomCrowds(places));
    }

    @Test
    void fewSpheresAreOneLeaf() {
        assertThat(rootsSpheres(0)).isZero();
        assertThat(rootsSpheres(1)).isEqualTo(1);
        assertThat(rootsSpheres(SphereHierarchy.FEWEST_SPHERES - 1)).isEqualTo(SphereHierarchy.FEWEST_SPHERES - 1);
        assertThat(rootsSpheres(SphereHierarchy.FEWEST_SPHERES)).isNegative();
    }

    private static float rootsSpheres(int spheres) {
        RandomCrowds crowd = RandomCrowds.of(new Random(1), spheres);
        float[] hierarchy = SphereHierarchy.of(crowd.places(), crowd.bodies());
        assertThat(hierarchy)
                .hasSize(crowd.places().length + Layout.spheresLength(crowd.bodies() - Layout.FIRST_SPHERE));
        return hierarchy[SphereHierarchy.root(crowd.bodies(), crowd.bodies(), 0) + Layout.NODE_SPHERES];
    }

    /** Traverses a hierarchy and checks it. */
    private static final class Walk {
        private final RandomCrowds crowd;
        private final float[] hierarchy;
        private final int mostInLeaf;
        private final int[] visits;

        Walk(RandomCrowds crowd, float[] hierarchy, int mostInLeaf) {
            this.crowd = crowd;
            this.hierarchy = hierarchy;
            this.mostInLeaf = mostInLeaf;
            visits = new int[crowd.bodies() - Layout.FIRST_SPHERE];
        }

        /** Returns the start and the end of the node's range of spheres. */
        int[] visit(int node, int ancestors) {
            assertThat(ancestors).isLessThanOrEqualTo(Layout.MOST_ANCESTORS);
            int link = (int) hierarchy[node + Layout.NODE_LINK];
            int spheres = (int) hierarchy[node + Layout.NODE_SPHERES];
            int[] span;
            if (spheres < 0) {
                int[] first = visit(link, ancestors + 1);
                int[] second = visit(link + Layout.NODE_STRIDE, ancestors + 1);
                assertThat(second[0]).isEqualTo(first[1]);
                span = new int[] {first[0], second[1]};
            } else {
                assertThat(spheres).isLessThanOrEqualTo(mostInLeaf);
                span = new int[] {link, link + spheres * Layout.SPHERE_STRIDE};
                for (int at = span[0]; at < span[1]; at += Layout.SPHERE_STRIDE) {
                    visitSphere(at);
                }
            }
            for (int at = span[0]; at < span[1]; at += Layout.SPHERE_STRIDE) {
                requireInside(at, node);
            }
            return span;
        }

        private void visitSphere(int at) {
            int body = (int) hierarchy[at + Layout.SPHERE_BODY];
            visits[body - Layout.FIRST_SPHERE]++;
            for (int axis = 0; axis < 3; axis++) {
                assertThat(hierarchy[at + axis]).isEqualTo(crowd.center(body, axis));
            }
            assertThat(hierarchy[at + Layout.SPHERE_RADIUS]).isEqualTo(crowd.radius(body));
        }

        private void requireInside(int at, int node) {
            double radius = hierarchy[at + Layout.SPHERE_RADIUS];
            for (int axis = 0; axis < 3; axis++) {
                double offCenter =
                        Math.abs((double) hierarchy[at + axis] - hierarchy[node + Layout.NODE_CENTER + axis]);
                if (!(offCenter + radius <= hierarchy[node + Layout.NODE_HALF + axis])) {
                    throw new AssertionError(
                            "axis " + axis + " of the sphere at " + at + " sticks out of node " + node);
                }
            }
        }
    }
}
