package dev.twister.kernel;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import dev.twister.world.SphereHierarchy;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class SoftShadowTest {
    private static final double GOLDEN_ANGLE = Math.PI * (3 - Math.sqrt(5));
    private static final int SAMPLES = 300;

    /** Light of radius 0.5 at height 10 over the origin, one sphere at height 4 straight below it. */
    @ParameterizedTest
    @ValueSource(floats = {0.01f, 0.1f, 0.2f, 0.3f, 0.39f, 0.45f, 3f})
    void sphereOnTheAxisHidesTheMiddleOfTheDisc(float radius) {
        double blockedSlope = Math.tan(Math.asin(radius / 4.0));
        int blocked = 0;
        for (int i = 0; i < SAMPLES; i++) {
            blocked += 2 * 0.5 * Math.sqrt((double) i / SAMPLES) / 10 <= blockedSlope ? 1 : 0;
        }
        float[] positions = {0, 10, 0, 0, 0, 0, 0, 4, 0};
        float[] sizes = {0.5f, 10, radius};
        assertThat(soft(positions, sizes, 0, 0, 0, Layout.PLANE, SAMPLES))
                .isCloseTo(1f - (float) blocked / SAMPLES, within(1e-6f));
    }

    @ParameterizedTest
    @CsvSource({
        "umbra, 0, 4, 0, 1, 0",
        "beside, 3, 4, 0, 1, 1",
        "behind the light, 0, 14, 0, 1, 1",
        "below the point, 0, -3, 0, 1, 1",
        "around the point, 0, 0.5, 0, 1, 1",
        "touching the point, 0, -1, 0, 1, 1",
        "around the light, 0, 10, 0, 2, 0"
    })
    void oneSphereHidesAllOrNothing(String where, float x, float y, float z, float radius, float visible) {
        float[] positions = {0, 10, 0, 0, 0, 0, x, y, z};
        float[] sizes = {0.5f, 10, radius};
        assertThat(soft(positions, sizes, 0, 0, 0, Layout.PLANE, SAMPLES))
                .as(where)
                .isEqualTo(visible);
        assertThat(plain(positions, sizes, 0, 0, 0, Layout.PLANE, SAMPLES))
                .as(where)
                .isEqualTo(visible);
    }

    @Test
    void ownBodyCastsNoShadowOnItself() {
        float[] positions = {0, 10, 0, 0, 0, 0, 0, 4, 0};
        float[] sizes = {0.5f, 10, 1};
        assertThat(soft(positions, sizes, 0, 0, 0, Layout.FIRST_SPHERE, SAMPLES))
                .isEqualTo(1f);
    }

    @Test
    void oneSampleIsTheHardShadow() {
        float[] positions = {0, 10, 0, 0, 0, 0, 0.9f, 4, 0};
        float[] sizes = {2f, 10, 1};
        assertThat(soft(positions, sizes, 0, 0, 0, Layout.PLANE, 1)).isZero();
        assertThat(soft(positions, sizes, -0.3f, 0, 0, Layout.PLANE, 1)).isEqualTo(1f);
    }

    @ParameterizedTest
    @CsvSource({"1, 0, 0", "-1, 0, 0", "0, 1, 0", "0, -1, 0", "0, 0, 1", "0, 0, -1"})
    void discsAxesAreThePlainOnesAlongEveryAxis(float x, float y, float z) {
        float[] positions = {10 * x, 10 * y, 10 * z, 0, 0, 0, 4 * x + 0.3f, 4 * y + 0.2f, 4 * z + 0.1f};
        float[] sizes = {1, 10, 0.5f};
        assertThat(soft(positions, sizes, 0, 0, 0, Layout.PLANE, 200))
                .isEqualTo(plain(positions, sizes, 0, 0, 0, Layout.PLANE, 200))
                .isBetween(0.05f, 0.95f);
    }

    /** Up to two hundred small spheres in the way: far more than a point remembers. A sample at a rim may fall on either side. */
    @Test
    void manySpheresHideWhatThePlainEquationsHide() {
        Random random = new Random(9);
        int samples = 64;
        double disagreeing = 0;
        double partlySeen = 0;
        int points = 4000;
        for (int i = 0; i < points; i++) {
            int spheres = 1 + random.nextInt(random.nextInt(20) == 0 ? 200 : 60);
            float[] positions = new float[3 * (2 + spheres)];
            float[] sizes = new float[2 + spheres];
            positions[1] = 10;
            sizes[Layout.LIGHT] = 1;
            for (int body = Layout.FIRST_SPHERE; body < sizes.length; body++) {
                positions[3 * body] = (float) random.nextGaussian();
                positions[3 * body + 1] = 11 * random.nextFloat() - 0.5f;
                positions[3 * body + 2] = (float) random.nextGaussian();
                sizes[body] = 0.02f + 0.25f * random.nextFloat();
            }
            float x = (float) random.nextGaussian();
            float z = (float) random.nextGaussian();
            float visible = soft(positions, sizes, x, 0, z, Layout.PLANE, samples);
            disagreeing += Math.abs(visible - plain(positions, sizes, x, 0, z, Layout.PLANE, samples)) * samples;
            partlySeen += visible > 0 && visible < 1 ? 1 : 0;
        }
        assertThat(partlySeen).isGreaterThan(points / 2.0);
        assertThat(disagreeing).isLessThan(1e-4 * samples * points);
    }

    /** By the plain loop over all spheres, to which the walk through a hierarchy is equal to the bit. */
    private static float soft(float[] positions, float[] sizes, float x, float y, float z, int own, int samples) {
        float visible = soft(positions, sizes, x, y, z, own, samples, sizes.length);
        for (int mostInLeaf = 1; mostInLeaf < 4; mostInLeaf++) {
            assertThat(soft(positions, sizes, x, y, z, own, samples, mostInLeaf))
                    .as("with at most %d spheres in a leaf", mostInLeaf)
                    .isEqualTo(visible);
        }
        return visible;
    }

    private static float soft(
            float[] positions, float[] sizes, float x, float y, float z, int own, int samples, int mostInLeaf) {
        float[] toLight = {positions[0] - x, positions[1] - y, positions[2] - z};
        float distance = length(toLight);
        return SoftShadow.visible(
                x,
                y,
                z,
                own,
                toLight[0] / distance,
                toLight[1] / distance,
                toLight[2] / distance,
                distance,
                2 * sizes[Layout.LIGHT],
                samples,
                sunflower(samples),
                SphereHierarchy.of(positions, sizes, sizes.length, mostInLeaf),
                Layout.root(sizes.length),
                new float[Layout.SCRATCH_LENGTH]);
    }

    private static float plain(float[] positions, float[] sizes, float x, float y, float z, int own, int samples) {
        float[] toLight = {positions[0] - x, positions[1] - y, positions[2] - z};
        float distance = length(toLight);
        return PlainShadow.visible(
                x,
                y,
                z,
                own,
                toLight[0] / distance,
                toLight[1] / distance,
                toLight[2] / distance,
                sizes[Layout.LIGHT],
                samples,
                positions,
                sizes,
                sizes.length);
    }

    private static float length(float[] vector) {
        return (float) Math.sqrt(vector[0] * vector[0] + vector[1] * vector[1] + vector[2] * vector[2]);
    }

    private static float[] sunflower(int samples) {
        float[] points = new float[2 * samples];
        for (int i = 0; i < samples; i++) {
            double distance = Math.sqrt((double) i / samples);
            points[2 * i] = (float) (distance * Math.cos(i * GOLDEN_ANGLE));
            points[2 * i + 1] = (float) (distance * Math.sin(i * GOLDEN_ANGLE));
        }
        return points;
    }
}
