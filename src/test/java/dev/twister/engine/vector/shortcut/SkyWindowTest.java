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
import java.util.Random;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

final class SkyWindowTest {
    private static final Scene SCENE = SceneReader.read(Path.of("scenes/teaching.json"));
    private static final int WIDTH = 12;
    private static final int HEIGHT = 9;
    private static final float THROUGHPUT = 0.5f;
    private static final float BEFORE = 2f;
    private static final int[] PACKETS = {32, 240};

    private final Random random = new Random(20261123);
    private final Tile tile = new Tile();
    private final PaddedSky sky = new PaddedSky();
    private final SkyWindow window = new SkyWindow();

    @BeforeEach
    void requireLanes() {
        assumeTrue(SkyWindow.FIT);
        for (int packet : PACKETS) {
            tile.skies.add(packet);
        }
    }

    /** Gives every texel a different color; whole numbers fit into half floats, thirds do not. */
    private void paintSky(boolean halved) {
        float[] radiance = new float[3 * WIDTH * HEIGHT];
        for (int number = 0; number < radiance.length; number++) {
            radiance[number] = number * 37 % 251 / (halved ? 1f : 3f);
        }
        sky.take(World.of(SCENE, new Skybox(WIDTH, HEIGHT, radiance)).snapshot());
        assertThat(sky.halved).isEqualTo(halved);
    }

    @ParameterizedTest
    @ValueSource(booleans = {true, false})
    void blendsEachLanesTexelsOfAnyWindow(boolean halved) {
        paintSky(halved);
        int fitting = 0;
        for (int count = 0; count < 3000; count++) {
            float left = 0.5f + random.nextFloat(WIDTH);
            float top = 0.5f + random.nextFloat(HEIGHT);
            float right = Math.min(left + random.nextFloat(7f), WIDTH + 0.5f);
            float bottom = Math.min(top + random.nextFloat(6f), HEIGHT + 0.5f);
            boolean fits = window.take(sky, left, top, right, bottom);
            int texels = ((int) right - (int) left + 2) * ((int) bottom - (int) top + 2);
            assertThat(fits).as("%d texels", texels).isEqualTo(texels <= 32);
            if (fits) {
                look(left, top, right, bottom);
                window.add(tile);
                assertColors();
                fitting++;
            }
        }
        assertThat(fitting).isBetween(1000, 2800);
    }

    /** Puts some lanes in the corners, marks some as hits, and places the others at random. */
    private void look(float left, float top, float right, float bottom) {
        for (int packet : PACKETS) {
            for (int lane = packet; lane < packet + Lanes.COUNT; lane++) {
                boolean corner = lane % 4 == 0;
                float column = corner ? (lane & 4) == 0 ? left : right : left + (right - left) * random.nextFloat();
                float row = corner ? (lane & 8) == 0 ? top : bottom : top + (bottom - top) * random.nextFloat();
                tile.values[Tile.SKY_TO_RIGHT + lane] = column;
                tile.values[Tile.SKY_TO_BOTTOM + lane] = row;
                tile.values[Tile.HIT + lane] = lane % 5 == 3 ? Layout.PLANE : Layout.NOTHING;
                tile.values[Tile.THROUGHPUT + lane] = THROUGHPUT;
                for (int channel = 0; channel < 3; channel++) {
                    tile.values[Tile.RED + channel * Tile.SIZE + lane] = BEFORE;
                }
            }
        }
    }

    /** Expects the bilinear mean of the four texels, times the throughput, added to the old value. */
    private void assertColors() {
        float[] t = tile.values;
        for (int packet : PACKETS) {
            for (int lane = packet; lane < packet + Lanes.COUNT; lane++) {
                double column = t[Tile.SKY_TO_RIGHT + lane];
                double row = t[Tile.SKY_TO_BOTTOM + lane];
                double toRight = column - Math.floor(column);
                double toBottom = row - Math.floor(row);
                int texel = 3 * (((int) row) * sky.stride() + (int) column);
                int below = 3 * sky.stride();
                double throughput = t[Tile.HIT + lane] == Layout.NOTHING ? THROUGHPUT : 0;
                for (int channel = 0; channel < 3; channel++) {
                    int at = texel + channel;
                    double upper = sky.value(at) * (1 - toRight) + sky.value(at + 3) * toRight;
                    double lower = sky.value(at + below) * (1 - toRight) + sky.value(at + below + 3) * toRight;
                    assertThat((double) t[Tile.RED + channel * Tile.SIZE + lane])
                            .as("lane %d at column %f, row %f, channel %d", lane, column, row, channel)
                            .isCloseTo(BEFORE + throughput * (upper * (1 - toBottom) + lower * toBottom), within(1e-3));
                }
            }
        }
    }
}
