package dev.twister.engine.vector.crowd;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assumptions.assumeThat;

import dev.twister.engine.vector.frame.WideHierarchy;
import dev.twister.engine.vector.lanes.Lanes;
import dev.twister.engine.vector.lanes.Tile;
import dev.twister.kernel.Intersection;
import dev.twister.world.SampleWorld;
import java.util.Arrays;
import java.util.Random;
import java.util.Set;
import java.util.TreeSet;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** Traversals that start below the root for a whole tile visit the same leaves as traversals from the root. */
final class WalkStartsTest {
    private static final int SPHERES = 3000;

    private final WideHierarchy hierarchy = new WideHierarchy();
    private final Tile tile = new Tile();
    private final TraversalMemory walks = new TraversalMemory();
    private final Random random = new Random(5);

    @BeforeEach
    void takeACrowd() {
        hierarchy.take(SampleWorld.crowd(SPHERES, 16, 16).snapshot());
    }

    @Test
    void theEntranceLeadsToAllThatAPacketMeets() {
        for (int view = 0; view < 100; view++) {
            lookDown(0.1);
            walks.beam.holdRays(tile, 0, tile.together.count);
            walks.beam.endAt(Beam.EVERYWHERE);
            boolean meets = walks.entrance.find(hierarchy, walks.beam);
            for (int packet = 0; packet < tile.together.count; packet++) {
                walks.beam.holdRays(tile, packet, packet + 1);
                walks.beam.endAt(Beam.EVERYWHERE);
                walks.descent.start(hierarchy, walks.beam);
                Set<Integer> fromTheRoot = leavesOfDescent();
                walks.descent.start(walks.entrance, walks.beam);
                assertThat(leavesOfDescent()).isEqualTo(fromTheRoot);
                assertThat(meets || fromTheRoot.isEmpty()).isTrue();
            }
        }
    }

    @Test
    void theEntranceIsFarBelowTheRootForRaysCloseTogether() {
        lookDown(0.001);
        walks.beam.holdRays(tile, 0, tile.together.count);
        walks.beam.endAt(Beam.EVERYWHERE);
        assertThat(walks.entrance.find(hierarchy, walks.beam)).isTrue();
        assertThat(WideHierarchy.isLeaf(walks.entrance.links[WideHierarchy.FIRST]))
                .isTrue();
    }

    @Test
    void whatMeetsNothingHasNoEntrance() {
        lookDown(0.1);
        for (int pixel = 0; pixel < Tile.SIZE; pixel++) {
            tile.values[Tile.DIRECTION_Y + pixel] = 1f;
        }
        walks.beam.holdRays(tile, 0, tile.together.count);
        walks.beam.endAt(Beam.EVERYWHERE);
        assertThat(walks.entrance.find(hierarchy, walks.beam)).isFalse();
    }

    @Test
    void aBeamInEachLaneMeetsTheRootsChildrenThatItMeetsAlone() {
        assumeThat(Lanes.PACK).isTrue();
        assertThat(hierarchy.rootChildren).isBetween(2, Lanes.COUNT - 1);
        int[] links = new int[(Lanes.COUNT + 1) * Lanes.COUNT];
        for (int turn = 0; turn < 200; turn++) {
            lookAround();
            int count = 1 + random.nextInt(Lanes.COUNT);
            walks.packetBeams.holdRays(tile.values, tile.pixels, 0);
            int end = RootChildren.list(hierarchy, walks.packetBeams, count, links);
            Set<Integer> found = new TreeSet<>();
            for (int k = 0; k < end; k++) {
                found.add(links[k]);
            }
            Set<Integer> alone = new TreeSet<>();
            for (int beam = 0; beam < count; beam++) {
                addRootChildrenMet(beam, alone);
            }
            assertThat(found).hasSize(end).isEqualTo(alone);
        }
    }

    @Test
    void manyBeamsComeToTheLeavesThatEachComesToAlone() {
        for (int turn = 0; turn < 200; turn++) {
            lookAround();
            Set<Integer> together = leavesOfBeams(0, Lanes.COUNT);
            Set<Integer> alone = new TreeSet<>();
            for (int beam = 0; beam < Lanes.COUNT; beam++) {
                for (int link : leavesOfBeams(beam, 1)) {
                    alone.add(link | beam << WideHierarchy.BEAM_SHIFT);
                }
            }
            assertThat(together).isEqualTo(alone);
        }
    }

    private void addRootChildrenMet(int beam, Set<Integer> met) {
        float[] entries = new float[Lanes.BORDER + Lanes.COUNT];
        walks.beam.holdRay(tile.values, beam);
        walks.beam.endAt(tile.values[Tile.DISTANCE + beam]);
        long lanes = walks.beam.meeting(hierarchy.boxes, WideHierarchy.FIRST, entries);
        for (long rest = lanes; rest != 0L; rest &= rest - 1) {
            int child = Long.numberOfTrailingZeros(rest);
            met.add(hierarchy.links[WideHierarchy.FIRST + child] | beam << WideHierarchy.BEAM_SHIFT);
        }
    }

    private Set<Integer> leavesOfBeams(int first, int count) {
        walks.packetBeams.holdRays(tile.values, tile.pixels, first);
        assertThat(walks.packetLeaves.find(hierarchy, walks.packetBeams, count)).isTrue();
        Set<Integer> leaves = new TreeSet<>();
        for (int k = walks.packetLeaves.first; k < walks.packetLeaves.end; k++) {
            leaves.add(walks.packetLeaves.links[k]);
        }
        return leaves;
    }

    private Set<Integer> leavesOfDescent() {
        Set<Integer> leaves = new TreeSet<>();
        int leaf = walks.descent.nextLeaf(hierarchy, walks.beam);
        while (leaf >= 0) {
            leaves.add(leaf);
            leaf = walks.descent.nextLeaf(hierarchy, walks.beam);
        }
        return leaves;
    }

    /** A tile of rays from a point high above downward, {@code spread} apart. */
    private void lookDown(double spread) {
        double x = 2 * random.nextDouble() - 1;
        double z = 2 * random.nextDouble() - 1;
        tile.together.clear();
        for (int pixel = 0; pixel < Tile.SIZE; pixel++) {
            start(pixel, 0, 60, 0);
            turn(
                    pixel,
                    0.4 * x + spread * Tile.column(pixel) / Tile.SIDE,
                    -1,
                    0.4 * z + spread * Tile.row(pixel) / Tile.SIDE);
            if (pixel % Lanes.COUNT == 0) {
                tile.together.add(pixel);
            }
        }
        Arrays.fill(tile.values, Tile.TOGETHER, Tile.TOGETHER + Tile.SIZE, 1f);
    }

    /** Rays from random points in the crowd in random directions. */
    private void lookAround() {
        for (int pixel = 0; pixel < Tile.SIZE; pixel++) {
            start(pixel, 40 * random.nextDouble() - 20, 5 * random.nextDouble(), 40 * random.nextDouble() - 20);
            turn(pixel, random.nextGaussian(), random.nextGaussian(), random.nextGaussian());
            tile.values[Tile.DISTANCE + pixel] = random.nextBoolean() ? Intersection.MISS : 10 * random.nextFloat();
        }
    }

    private void start(int pixel, double x, double y, double z) {
        tile.values[Tile.ORIGIN_X + pixel] = (float) x;
        tile.values[Tile.ORIGIN_Y + pixel] = (float) y;
        tile.values[Tile.ORIGIN_Z + pixel] = (float) z;
    }

    private void turn(int pixel, double x, double y, double z) {
        double length = Math.sqrt(x * x + y * y + z * z);
        tile.values[Tile.DIRECTION_X + pixel] = (float) (x / length);
        tile.values[Tile.DIRECTION_Y + pixel] = (float) (y / length);
        tile.values[Tile.DIRECTION_Z + pixel] = (float) (z / length);
    }
}
