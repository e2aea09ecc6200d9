package dev.twister.engine;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import dev.twister.engine.NoiseEstimate.Half;
import dev.twister.engine.RareLight.Finds;
import dev.twister.kernel.Layout;
import dev.twister.world.SampleWorld;
import java.util.Arrays;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;

class RareLightTest {
    private static final int SIDE = Layout.TILE_SIDE;
    private static final int PIXELS = SIDE * SIDE;
    private static final int ACROSS = 8;

    @Test
    void aFindCountsInTilesBeside() {
        RareLight rare = of(1);

        // One find may as well have been 1 + 2.5 standard deviations twice over, in five tiles.
        assertThat(rare.missing(ACROSS + 3)[0]).isCloseTo(2.5 * 2 / (5 * PIXELS), within(1e-9));
        assertThat(IntStream.range(0, 2 * ACROSS).filter(tile -> rare.missing(tile)[0] > 0))
                .containsExactly(ACROSS + 1, ACROSS + 2, ACROSS + 3, ACROSS + 4, ACROSS + 5);
    }

    @Test
    void manyFindsLeaveLittleUnknown() {
        double each = of(1).missing(ACROSS + 3)[0];

        // Of sixteen times the light, 2.5 * (4 + 1) / 16 is unknown, instead of 2.5 * (1 + 1).
        assertThat(of(16).missing(ACROSS + 3)[0]).isCloseTo(each * 16 * 12.5 / 16 / 5, within(1e-9));
    }

    @Test
    void noiseOfAllPixelsIsNotRare() {
        double[] deviations = IntStream.range(0, 3 * PIXELS)
                .mapToDouble(value -> 1 + value % 7)
                .toArray();

        assertThat(Finds.of(deviations).sum()).isZero();
    }

    @Test
    void aTileThatFoundNothingKnowsOfItsNeighbors() {
        int width = ACROSS * SIDE;
        float[] one = new float[3 * width * SIDE];
        Arrays.fill(one, 8 * 0.2f);
        float[] other = one.clone();
        NoiseEstimate estimate = new NoiseEstimate(
                width, SampleWorld.ofSize(width, SIDE).snapshot().view().frame());
        assertThat(estimate.of(new Half(one, 8), new Half(other, 8))).isZero();

        one[3 * (3 * SIDE + 5)] = 8 * 300;
        double[] noise = estimate.tiles(new Half(one, 8), new Half(other, 8));
        assertThat(noise[0]).isZero();
        assertThat(noise[1]).isGreaterThan(0.05);
        assertThat(noise[5]).isGreaterThan(0.05);
        assertThat(noise[6]).isZero();
    }

    /** Tiles in two rows, one of which has a number of finds of brightness 1. */
    private static RareLight of(int finds) {
        Finds none = Finds.of(new double[3 * PIXELS]);
        Finds[] tiles = new Finds[2 * ACROSS];
        Arrays.fill(tiles, none);
        double[] deviations = new double[3 * PIXELS];
        Arrays.fill(deviations, 0, 3 * finds, 1);
        tiles[ACROSS + 3] = Finds.of(deviations);
        return new RareLight(ACROSS, tiles);
    }
}
