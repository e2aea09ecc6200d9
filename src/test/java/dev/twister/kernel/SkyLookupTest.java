package dev.twister.kernel;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Arrays;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class SkyLookupTest {
    private static final int[][] SIZES = {{1, 1}, {2, 1}, {1, 2}, {3, 2}, {7, 5}, {64, 32}};

    private static final float[] TURNS = {0, 0.25f, 0.7f};

    @Test
    void everyDirectionIsTheBilinearInDoubles() {
        Random random = new Random(5);
        for (int[] size : SIZES) {
            float[] sky = noise(random, size[0], size[1]);
            for (int i = 0; i < 7000; i++) {
                assertLookup(sky, size, random.nextGaussian(), random.nextGaussian(), random.nextGaussian());
            }
        }
    }

    @Test
    void panoramaWrapsBehind() {
        Random random = new Random(6);
        for (int[] size : SIZES) {
            float[] sky = noise(random, size[0], size[1]);
            for (double z : new double[] {0, 1e-9, -1e-9, 1e-3, -1e-3, 0.2, -0.2}) {
                assertLookup(sky, size, z, random.nextGaussian(), -1);
            }
        }
    }

    @Test
    void polesAreClamped() {
        Random random = new Random(7);
        for (int[] size : SIZES) {
            float[] sky = noise(random, size[0], size[1]);
            for (double y : new double[] {1, -1}) {
                assertLookup(sky, size, 0, y, 0);
                assertLookup(sky, size, 1e-3, y, -1e-3);
                assertLookup(sky, size, -1e-5, y, 2e-6);
            }
        }
    }

    @ParameterizedTest
    @CsvSource({"0, 0, 1, 2", "1, 0, 0, 3", "0, 0, -1, 0", "-1, 0, 0, 1"})
    void axesAreQuartersOfThePanorama(float x, float y, float z, float quarters) {
        assertThat(SkyLookup.column(x, z, 0f, 4) + 0.5f).isCloseTo(quarters == 0 ? 4 : quarters, within(1e-6f));
        assertThat(SkyLookup.row(x, y, z, 4)).isCloseTo(1.5f, within(1e-6f));
    }

    @ParameterizedTest
    @CsvSource({"0.25, 1, 0, 2", "0.5, 0, -1, 2", "0.75, -1, 0, 2", "0.25, 0, 1, 1"})
    void turnMovesThePanoramaToTheRight(float turn, float x, float z, float quarters) {
        assertThat(SkyLookup.column(x, z, turn, 4) + 0.5f).isCloseTo(quarters, within(1e-6f));
    }

    @Test
    void strengthMultipliesTheRadiance() {
        float[] path = Paths.ray(new float[3], new float[] {0, 0, 1}, Layout.NOTHING);
        Arrays.fill(path, Layout.THROUGHPUT, Layout.THROUGHPUT + 3, 0.5f);
        float[] frame = new float[Layout.DISC];
        frame[Layout.SKY_STRENGTH] = 3f;
        frame[Layout.SKY_WIDTH] = 1f;
        frame[Layout.SKY_HEIGHT] = 1f;
        SkyLookup.add(path, frame, new float[] {1, 2, 4});
        assertThat(path[Layout.RADIANCE]).isEqualTo(1.5f);
        assertThat(path[Layout.RADIANCE + 2]).isEqualTo(6f);
    }

    private static void assertLookup(float[] sky, int[] size, double x, double y, double z) {
        for (float turn : TURNS) {
            assertLookup(sky, size, turn, x, y, z);
        }
    }

    private static void assertLookup(float[] sky, int[] size, float turn, double x, double y, double z) {
        double length = Math.sqrt(x * x + y * y + z * z);
        float directionX = (float) (x / length);
        float directionY = (float) (y / length);
        float directionZ = (float) (z / length);
        float column = SkyLookup.column(directionX, directionZ, turn, size[0]);
        float row = SkyLookup.row(directionX, directionY, directionZ, size[1]);
        for (int channel = 0; channel < 3; channel++) {
            assertThat((double) SkyLookup.radiance(size[0], size[1], column, row, channel, sky))
                    .as("%s x %s toward (%s, %s, %s)", size[0], size[1], x, y, z)
                    .isCloseTo(bilinear(sky, size, turn, directionX, directionY, directionZ, channel), within(1e-4));
        }
    }

    /** Near the zenith the elevation uses an arc tangent, as the arc sine of a rounded unit vector loses precision. */
    private static double bilinear(float[] sky, int[] size, float turn, double x, double y, double z, int channel) {
        double column = (0.5 + Math.atan2(x, z) / (2 * Math.PI) - turn) * size[0] - 0.5;
        double row = (0.5 - Math.atan2(y, Math.hypot(x, z)) / Math.PI) * size[1] - 0.5;
        double toRight = column - Math.floor(column);
        double toBottom = row - Math.floor(row);
        double sum = 0;
        for (int down = 0; down <= 1; down++) {
            for (int across = 0; across <= 1; across++) {
                int texelColumn = Math.floorMod((int) Math.floor(column) + across, size[0]);
                int texelRow = Math.clamp((int) Math.floor(row) + down, 0, size[1] - 1);
                sum += sky[3 * (texelRow * size[0] + texelColumn) + channel]
                        * (across == 1 ? toRight : 1 - toRight)
                        * (down == 1 ? toBottom : 1 - toBottom);
            }
        }
        return sum;
    }

    private static float[] noise(Random random, int width, int height) {
        float[] sky = new float[3 * width * height];
        for (int i = 0; i < sky.length; i++) {
            sky[i] = 2 * random.nextFloat();
        }
        return sky;
    }
}
