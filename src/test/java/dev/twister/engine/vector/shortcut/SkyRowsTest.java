package dev.twister.engine.vector.shortcut;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import dev.twister.engine.vector.frame.PaddedSky;
import dev.twister.engine.vector.lanes.Lanes;
import dev.twister.engine.vector.lanes.Tile;
import dev.twister.kernel.Layout;
import dev.twister.scene.Scene;
import dev.twister.scene.format.SceneReader;
import dev.twister.sky.Skybox;
import dev.twister.world.World;
import java.nio.file.Path;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

final class SkyRowsTest {
    private static final Scene SCENE = SceneReader.read(Path.of("scenes/teaching.json"));
    private static final int WIDTH = 12;
    private static final int HEIGHT = 6;
    private static final float THROUGHPUT = 0.5f;
    private static final float BEFORE = 2f;

    private final Tile tile = new Tile();
    private final PaddedSky sky = new PaddedSky();

    /** Gives every texel a different color, with few enough bits for half floats. */
    @BeforeEach
    void paintSky() {
        assumeTrue(SkyRows.FIT);
        float[] radiance = new float[3 * WIDTH * HEIGHT];
        for (int number = 0; number < radiance.length; number++) {
            radiance[number] = number * 37 % 251;
        }
        sky.take(World.of(SCENE, new Skybox(WIDTH, HEIGHT, radiance)).snapshot());
        assertThat(sky.halved).isTrue();
    }

    /** The first and last texels of the padded sky are its border. */
    @Test
    void blendsEachLanesTexelsWhereverThePatchLies() {
        for (int left = 0; left <= WIDTH; left++) {
            for (int top = 0; top <= HEIGHT; top++) {
                for (int anchor = 0; anchor < 2; anchor++) {
                    float firstColumn = Math.min(WIDTH + 0.75f, left + anchor);
                    float firstRow = Math.min(HEIGHT + 0.75f, top + anchor);
                    for (int lane = 0; lane < Lanes.COUNT; lane++) {
                        float column = Math.min(WIDTH + 0.75f, left + lane % 4 * 0.59f);
                        float row = Math.min(HEIGHT + 0.75f, top + (lane >> 2) * 0.48f);
                        look(lane, lane == 0 ? firstColumn : column, lane == 0 ? firstRow : row);
                    }
                    sort();
                    assertThat(tile.skyPatches.count)
                            .as("patches at column %d, row %d", left, top)
                            .isEqualTo(1);
                    assertThat(tile.scatteredSkies.count).isZero();
                    SkyRows.add(tile, sky);
                    for (int lane = 0; lane < Lanes.COUNT; lane++) {
                        assertColor(lane, THROUGHPUT);
                    }
                }
            }
        }
    }

    @Test
    void lanesThatMetAnythingElseNeitherCountNorChange() {
        for (int lane = 0; lane < Lanes.COUNT; lane++) {
            look(lane, lane == 0 || lane == 7 ? 9.5f : 2.25f, lane == 3 ? 5.5f : 1.75f);
        }
        for (int lane : new int[] {0, 3, 7}) {
            tile.values[Tile.HIT + lane] = Layout.PLANE;
        }
        sort();
        assertThat(tile.skyPatches.count).isEqualTo(1);
        SkyRows.add(tile, sky);
        for (int lane = 0; lane < Lanes.COUNT; lane++) {
            assertColor(lane, tile.values[Tile.HIT + lane] == Layout.NOTHING ? THROUGHPUT : 0f);
        }
    }

    @Test
    void packetsThatLookFurtherApartAreScattered() {
        float[][] looks = {
            {2.5f, 1.5f, 6.5f, 1.5f}, {6.5f, 1.5f, 2.5f, 1.5f}, {2.5f, 1.5f, 2.5f, 3f}, {2.5f, 3f, 2.5f, 1.5f}
        };
        for (float[] look : looks) {
            for (int lane = 0; lane < Lanes.COUNT; lane++) {
                look(lane, lane < 5 ? look[0] : look[2], lane < 5 ? look[1] : look[3]);
            }
            sort();
            assertThat(tile.skyPatches.count).isZero();
            assertThat(tile.scatteredSkies.count).isEqualTo(1);
        }
    }

    private void look(int lane, float column, float row) {
        tile.values[Tile.SKY_TO_RIGHT + lane] = column;
        tile.values[Tile.SKY_TO_BOTTOM + lane] = row;
        tile.values[Tile.HIT + lane] = Layout.NOTHING;
        tile.values[Tile.THROUGHPUT + lane] = THROUGHPUT;
        for (int channel = 0; channel < 3; channel++) {
            tile.values[Tile.RED + channel * Tile.SIZE + lane] = BEFORE;
        }
    }

    private void sort() {
        tile.skies.clear();
        tile.skies.add(0);
        SkyRows.sort(tile);
    }

    /** Expects the bilinear mean of the four texels, times {@code throughput}, added to the old value. */
    private void assertColor(int lane, float throughput) {
        double column = tile.values[Tile.SKY_TO_RIGHT + lane];
        double row = tile.values[Tile.SKY_TO_BOTTOM + lane];
        double toRight = column - Math.floor(column);
        double toBottom = row - Math.floor(row);
        int texel = 3 * (((int) row) * sky.stride() + (int) column);
        int below = 3 * sky.stride();
        for (int channel = 0; channel < 3; channel++) {
            int at = texel + channel;
            double upper = sky.value(at) * (1 - toRight) + sky.value(at + 3) * toRight;
            double lower = sky.value(at + below) * (1 - toRight) + sky.value(at + below + 3) * toRight;
            assertThat((double) tile.values[Tile.RED + channel * Tile.SIZE + lane])
                    .as("lane %d at column %f, row %f, channel %d", lane, column, row, channel)
                    .isCloseTo(BEFORE + throughput * (upper * (1 - toBottom) + lower * toBottom), within(1e-3));
        }
    }
}
