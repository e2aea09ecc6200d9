package dev.twister.kernel;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** The finish of a sphere whose maps have one texel each, against the same in double precision. */
class FinishMapsTest {
    private static final int ROW = Layout.LOOK_STRIDE * (Layout.FIRST_SPHERE + 1);
    private static final int VARIANT = Variant.MATERIALS | Variant.PATH | Variant.MAPS | Variant.FINISH;
    private static final float SPECULAR_LOSS = 0.3f;

    private final float[] looks = new float[ROW + Layout.FINISH_STRIDE];
    private final float[] images =
            new float[Layout.ALIGNMENT * (Layout.FINISH_STRIDE - Layout.FINISH_MAPS_COAT) / Layout.MAP_STRIDE];
    private final float[] path = new float[Layout.FINISHED_PATH_LENGTH];
    private final Random random = new Random(71);
    private final double[] outward = new double[3];

    @ParameterizedTest
    @ValueSource(booleans = {false, true})
    void withoutMapsItIsTheRows(boolean inside) {
        put(inside);
        find();

        for (int number = 0; number < Layout.FINISH_LENGTH; number++) {
            assertThat(path[Layout.FINISH + number]).isEqualTo(looks[ROW + number]);
        }
        assertThat(path[Layout.SPECULAR_LOSS]).isEqualTo(SPECULAR_LOSS);
        double side = inside ? -1 : 1;
        assertVector(Layout.COAT_NORMAL, side * outward[0], side * outward[1], side * outward[2]);
        assertGrain(looks[ROW + Layout.FINISH_GRAIN_COSINE], looks[ROW + Layout.FINISH_GRAIN_SINE]);
    }

    @ParameterizedTest
    @ValueSource(booleans = {false, true})
    void mapsMultiply(boolean inside) {
        put(inside);
        for (int map = Layout.FINISH_MAPS_COAT; map < Layout.FINISH_STRIDE; map += Layout.MAP_STRIDE) {
            putMap(map);
        }
        find();

        assertNumber(Layout.FINISH_COAT, texel(Layout.FINISH_MAPS_COAT, 0));
        assertNumber(Layout.FINISH_COAT_ROUGHNESS, texel(Layout.FINISH_MAPS_COAT_ROUGHNESS, 1));
        assertColor(Layout.FINISH_SHEEN, Layout.FINISH_MAPS_SHEEN);
        assertNumber(Layout.FINISH_SHEEN_ROUGHNESS, texel(Layout.FINISH_MAPS_SHEEN_ROUGHNESS, 0));
        assertNumber(Layout.FINISH_ANISOTROPY, texel(Layout.FINISH_MAPS_ANISOTROPY, 2));
        assertColor(Layout.FINISH_SPECULAR_COLOR, Layout.FINISH_MAPS_SPECULAR_COLOR);
        assertThat((double) path[Layout.SPECULAR_LOSS])
                .isEqualTo(1 - (1 - SPECULAR_LOSS) * texel(Layout.FINISH_MAPS_SPECULAR, 0), within(1e-6));
        assertNumber(Layout.FINISH_FILM, texel(Layout.FINISH_MAPS_FILM, 0));
        assertNumber(Layout.FINISH_FILM_IOR, 1);
        double least = looks[ROW + Layout.FINISH_FILM_LEAST];
        double most = looks[ROW + Layout.FINISH_FILM_THICKNESS];
        assertThat((double) path[Layout.FINISH + Layout.FINISH_FILM_THICKNESS])
                .isEqualTo(least + texel(Layout.FINISH_MAPS_FILM_THICKNESS, 1) * (most - least), within(1e-6));
        assertNumber(Layout.FINISH_DISPERSION, 1);
        assertNumber(Layout.FINISH_THROUGH, texel(Layout.FINISH_MAPS_THROUGH, 0));
        assertColor(Layout.FINISH_THROUGH_COLOR, Layout.FINISH_MAPS_THROUGH_COLOR);
        double angle = Math.atan2(looks[ROW + Layout.FINISH_GRAIN_SINE], looks[ROW + Layout.FINISH_GRAIN_COSINE])
                + Math.atan2(
                        2 * texel(Layout.FINISH_MAPS_ANISOTROPY, 1) - 1,
                        2 * texel(Layout.FINISH_MAPS_ANISOTROPY, 0) - 1);
        assertGrain(Math.cos(angle), Math.sin(angle));
    }

    @ParameterizedTest
    @ValueSource(booleans = {false, true})
    void theCoatHasItsOwnNormals(boolean inside) {
        put(inside);
        putMap(Layout.FINISH_MAPS_COAT_NORMAL);
        int texel = texelAt(Layout.FINISH_MAPS_COAT_NORMAL);
        images[texel] = 0.6f;
        images[texel + 1] = 0.45f;
        images[texel + 2] = 0.95f;
        float[] before = path.clone();
        find();

        double scale = looks[ROW + Layout.FINISH_COAT_NORMAL_SCALE];
        double[] turned = new double[3];
        for (int axis = 0; axis < 3; axis++) {
            turned[axis] = scale * 0.2 * right()[axis] - scale * 0.1 * up()[axis] + 0.9 * outward[axis];
        }
        double length = (inside ? -1 : 1) * Math.hypot(Math.hypot(turned[0], turned[1]), turned[2]);
        assertVector(Layout.COAT_NORMAL, turned[0] / length, turned[1] / length, turned[2] / length);
        assertVector(Layout.NORMAL, before[Layout.NORMAL], before[Layout.NORMAL + 1], before[Layout.NORMAL + 2]);
    }

    @Test
    void theGrainFollowsTheTurnedNormal() {
        put(false);
        find();
        double[] grain = {path[Layout.GRAIN], path[Layout.GRAIN + 1], path[Layout.GRAIN + 2]};
        path[Layout.NORMAL] = 0.6f;
        path[Layout.NORMAL + 1] = 0;
        path[Layout.NORMAL + 2] = 0.8f;
        path[Layout.IS_FINISHED] = 1;
        FinishMaps.straighten(path);

        double along = 0.6 * grain[0] + 0.8 * grain[2];
        double x = grain[0] - 0.6 * along;
        double z = grain[2] - 0.8 * along;
        double length = Math.hypot(Math.hypot(x, grain[1]), z);
        assertVector(Layout.GRAIN, x / length, grain[1] / length, z / length);
    }

    @Test
    void atThePoleTheGrainIsAnyAcrossTheNormal() {
        put(false);
        path[Layout.NORMAL] = 0;
        path[Layout.NORMAL + 1] = 1;
        path[Layout.NORMAL + 2] = 0;
        find();

        assertThat(path[Layout.GRAIN + 1]).isEqualTo(0, within(1e-6f));
        assertThat(Math.hypot(path[Layout.GRAIN], path[Layout.GRAIN + 2])).isEqualTo(1, within(1e-6));
    }

    @Test
    void aBodyWithoutAFinishIsLeftAlone() {
        put(false);
        looks[Layout.LOOK_STRIDE * Layout.FIRST_SPHERE + Layout.LOOK_FINISH] = 0;
        float[] before = path.clone();
        find();

        assertThat(path).isEqualTo(before);
    }

    private void put(boolean inside) {
        looks[Layout.LOOK_STRIDE * Layout.FIRST_SPHERE + Layout.LOOK_FINISH] = ROW;
        for (int number = 0; number < Layout.FINISH_MAPS_COAT; number++) {
            looks[ROW + number] = random.nextFloat();
        }
        double angle = 2;
        looks[ROW + Layout.FINISH_GRAIN_COSINE] = (float) Math.cos(angle);
        looks[ROW + Layout.FINISH_GRAIN_SINE] = (float) Math.sin(angle);
        double[] normal = {0.48, -0.6, -0.64};
        for (int axis = 0; axis < 3; axis++) {
            outward[axis] = normal[axis];
            path[Layout.NORMAL + axis] = (float) (inside ? -normal[axis] : normal[axis]);
            path[Layout.DIRECTION + axis] = (float) (inside ? normal[axis] : -normal[axis]);
        }
        path[Layout.FROM_INSIDE] = inside ? 1 : 0;
        path[Layout.SPECULAR_LOSS] = SPECULAR_LOSS;
    }

    private void putMap(int map) {
        int start = texelAt(map) / Layout.ALIGNMENT;
        looks[ROW + map + Layout.MAP_START] = start;
        looks[ROW + map + Layout.MAP_WIDTH] = 1;
        looks[ROW + map + Layout.MAP_HEIGHT] = 1;
        for (int channel = 0; channel < 3; channel++) {
            images[texelAt(map) + channel] = random.nextFloat();
        }
    }

    private static int texelAt(int map) {
        return Layout.ALIGNMENT * (map - Layout.FINISH_MAPS_COAT) / Layout.MAP_STRIDE;
    }

    private double texel(int map, int channel) {
        return images[texelAt(map) + channel];
    }

    private void find() {
        FinishMaps.find(
                path, Layout.FIRST_SPHERE, new float[Layout.DISC], new float[0], looks, new float[0], images, VARIANT);
    }

    /** Unit vectors right and up on an image around the sphere. */
    private double[] right() {
        double level = Math.hypot(outward[0], outward[2]);
        return new double[] {-outward[2] / level, 0, outward[0] / level};
    }

    private double[] up() {
        double level = Math.hypot(outward[0], outward[2]);
        return new double[] {-outward[0] * outward[1] / level, level, -outward[2] * outward[1] / level};
    }

    private void assertGrain(double cosine, double sine) {
        assertVector(
                Layout.GRAIN,
                cosine * right()[0] + sine * up()[0],
                cosine * right()[1] + sine * up()[1],
                cosine * right()[2] + sine * up()[2]);
    }

    private void assertColor(int number, int map) {
        for (int channel = 0; channel < 3; channel++) {
            assertNumber(number + channel, texel(map, channel));
        }
    }

    private void assertNumber(int number, double factor) {
        assertThat((double) path[Layout.FINISH + number])
                .as("number " + number)
                .isEqualTo(looks[ROW + number] * factor, within(1e-6));
    }

    private void assertVector(int at, double x, double y, double z) {
        assertThat((double) path[at]).isEqualTo(x, within(2e-6));
        assertThat((double) path[at + 1]).isEqualTo(y, within(2e-6));
        assertThat((double) path[at + 2]).isEqualTo(z, within(2e-6));
    }
}
