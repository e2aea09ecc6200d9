package dev.twister.kernel;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import dev.twister.world.hierarchy.SphereHierarchy;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class ShadowTest {
    private static final double GOLDEN_ANGLE = Math.PI * (3 - Math.sqrt(5));
    private static final int SAMPLES = 300;

    /** A light of radius 0.5 at height 10 above the origin, and a sphere at height 4 below its center. */
    @ParameterizedTest
    @ValueSource(floats = {0.01f, 0.1f, 0.2f, 0.3f, 0.39f, 0.45f, 3f})
    void sphereOnTheAxisHidesTheMiddleOfTheDisc(float radius) {
        double blockedSlope = Math.tan(Math.asin(radius / 4.0));
        int blocked = 0;
        for (int i = 0; i < SAMPLES; i++) {
            blocked += 2 * 0.5 * Math.sqrt((double) i / SAMPLES) / 10 <= blockedSlope ? 1 : 0;
        }
        float[] places = {0, 10, 0, 0.5f, 0, 0, 0, 10, 0, 4, 0, radius};
        assertThat(soft(places, 0, 0, 0, Layout.PLANE, SAMPLES))
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
        float[] places = {0, 10, 0, 0.5f, 0, 0, 0, 10, x, y, z, radius};
        assertThat(soft(places, 0, 0, 0, Layout.PLANE, SAMPLES)).as(where).isEqualTo(visible);
        assertThat(plain(places, 0, 0, 0, Layout.PLANE, SAMPLES)).as(where).isEqualTo(visible);
    }

    /** A point on a sphere far away, and the height of the light's center from which the plane is lit. */
    @ParameterizedTest
    @CsvSource({
        "light below, 0, 2, -10, 0",
        "point below, 0, -2, 10, 0",
        "both above, 0, 2, 10, 1",
        "both below, 0, -2, -10, 1",
        "past the border, 5.1, 2, -10, 1",
        "just inside the border, 4, 2, -10, 0",
        "point on the plane, 0, 0, -10, 1"
    })
    void planeHidesTheLightOnTheOtherSide(String where, float x, float y, float lightHeight, float visible) {
        float[] places = {x, lightHeight, 0, 0.01f, 0, 0, 0, 10, 100, 100, 100, 1};
        assertThat(soft(places, x, y, 0, Layout.FIRST_SPHERE, SAMPLES))
                .as(where)
                .isEqualTo(visible);
        assertThat(plain(places, x, y, 0, Layout.FIRST_SPHERE, SAMPLES))
                .as(where)
                .isEqualTo(visible);
        assertThat(soft(places, x, y, 0, Layout.PLANE, SAMPLES)).as(where).isEqualTo(1f);
    }

    @Test
    void planeHidesThePartOfTheDiscThatIsBelow() {
        float[] places = {3, 0, 0, 1, 0, 0, 0, 10, 100, 100, 100, 1};
        assertThat(soft(places, 0, 2, 0.5f, Layout.FIRST_SPHERE, 500))
                .isEqualTo(plain(places, 0, 2, 0.5f, Layout.FIRST_SPHERE, 500))
                .isBetween(0.45f, 0.55f);
        assertThat(soft(places, 0, 2, 0.5f, Layout.FIRST_SPHERE, 1)).isEqualTo(1f);
    }

    /** Points, lights and small spheres on either side, near the border and far from it. */
    @Test
    void planeAndSpheresHideWhatThePlainEquationsHide() {
        Random random = new Random(10);
        int samples = 64;
        int points = 4000;
        double disagreeing = 0;
        double partlySeen = 0;
        for (int i = 0; i < points; i++) {
            float[] places = new float[4 * Layout.PLACE_STRIDE];
            for (int at = 0; at < places.length; at++) {
                places[at] = 4 * random.nextFloat() - 2;
            }
            places[Layout.PLACE_SIZE] = 0.5f * random.nextFloat();
            places[Layout.PLACE_STRIDE * Layout.PLANE + Layout.PLACE_SIZE] = 3 * random.nextFloat();
            places[Layout.PLACE_STRIDE * 2 + Layout.PLACE_SIZE] = 0.3f * random.nextFloat();
            places[Layout.PLACE_STRIDE * 3 + Layout.PLACE_SIZE] = 0.3f * random.nextFloat();
            float x = 4 * random.nextFloat() - 2;
            float y = 4 * random.nextFloat() - 2;
            float z = 4 * random.nextFloat() - 2;
            float visible = soft(places, x, y, z, Layout.FIRST_SPHERE, samples);
            disagreeing += Math.abs(visible - plain(places, x, y, z, Layout.FIRST_SPHERE, samples)) * samples;
            partlySeen += visible > 0 && visible < 1 ? 1 : 0;
        }
        assertThat(partlySeen).isGreaterThan(points / 20.0);
        assertThat(disagreeing).isLessThan(1e-4 * samples * points);
    }

    @Test
    void ownBodyCastsNoShadowOnItself() {
        float[] places = {0, 10, 0, 0.5f, 0, 0, 0, 10, 0, 4, 0, 1};
        assertThat(soft(places, 0, 0, 0, Layout.FIRST_SPHERE, SAMPLES)).isEqualTo(1f);
    }

    @Test
    void oneSampleIsTheHardShadow() {
        float[] places = {0, 10, 0, 2, 0, 0, 0, 10, 0.9f, 4, 0, 1};
        assertThat(soft(places, 0, 0, 0, Layout.PLANE, 1)).isZero();
        assertThat(soft(places, -0.3f, 0, 0, Layout.PLANE, 1)).isEqualTo(1f);
    }

    @ParameterizedTest
    @CsvSource({"1, 0, 0", "-1, 0, 0", "0, 1, 0", "0, -1, 0", "0, 0, 1", "0, 0, -1"})
    void discsAxesAreThePlainOnesAlongEveryAxis(float x, float y, float z) {
        float[] places = {10 * x, 10 * y, 10 * z, 1, 0, 0, 0, 10, 4 * x + 0.3f, 4 * y + 0.2f, 4 * z + 0.1f, 0.5f};
        assertThat(soft(places, 0, 0, 0, Layout.PLANE, 200))
                .isEqualTo(plain(places, 0, 0, 0, Layout.PLANE, 200))
                .isBetween(0.05f, 0.95f);
    }

    /**
     * Up to two hundred small occluders, far more than a point's candidate list holds. A sample at a rim may fall on
     * either side.
     */
    @Test
    void manySpheresHideWhatThePlainEquationsHide() {
        Random random = new Random(9);
        int samples = 64;
        double disagreeing = 0;
        double partlySeen = 0;
        int points = 4000;
        for (int i = 0; i < points; i++) {
            int spheres = 1 + random.nextInt(random.nextInt(20) == 0 ? 200 : 60);
            float[] places = new float[Layout.PLACE_STRIDE * (Layout.FIRST_SPHERE + spheres)];
            places[1] = 10;
            places[Layout.PLACE_SIZE] = 1;
            for (int at = Layout.PLACE_STRIDE * Layout.FIRST_SPHERE; at < places.length; at += Layout.PLACE_STRIDE) {
                places[at] = (float) random.nextGaussian();
                places[at + 1] = 11 * random.nextFloat() - 0.5f;
                places[at + 2] = (float) random.nextGaussian();
                places[at + Layout.PLACE_SIZE] = 0.02f + 0.25f * random.nextFloat();
            }
            float x = (float) random.nextGaussian();
            float z = (float) random.nextGaussian();
            float visible = soft(places, x, 0, z, Layout.PLANE, samples);
            disagreeing += Math.abs(visible - plain(places, x, 0, z, Layout.PLANE, samples)) * samples;
            partlySeen += visible > 0 && visible < 1 ? 1 : 0;
        }
        assertThat(partlySeen).isGreaterThan(points / 2.0);
        assertThat(disagreeing).isLessThan(1e-4 * samples * points);
    }

    /** Computes visibility by brute force over all spheres; traversal of a hierarchy gives the same bits. */
    private static float soft(float[] places, float x, float y, float z, int own, int samples) {
        float visible = soft(places, x, y, z, own, samples, bodies(places));
        for (int mostInLeaf = 1; mostInLeaf < 4; mostInLeaf++) {
            assertThat(soft(places, x, y, z, own, samples, mostInLeaf))
                    .as("with at most %d spheres in a leaf", mostInLeaf)
                    .isEqualTo(visible);
        }
        return visible;
    }

    private static float soft(float[] places, float x, float y, float z, int own, int samples, int mostInLeaf) {
        return Shadow.visible(
                lit(places, x, y, z),
                own,
                new float[Layout.SCRATCH_LENGTH],
                Paths.frame(bodies(places), sunflower(samples)),
                SphereHierarchy.of(places, bodies(places), new int[0], mostInLeaf),
                new float[0],
                new float[0],
                Variant.WALK);
    }

    private static float plain(float[] places, float x, float y, float z, int own, int samples) {
        return PlainShadow.visible(lit(places, x, y, z), own, samples, places, bodies(places));
    }

    private static int bodies(float[] places) {
        return places.length / Layout.PLACE_STRIDE;
    }

    private static float[] lit(float[] places, float x, float y, float z) {
        float[] toLight = {places[0] - x, places[1] - y, places[2] - z};
        float distance = length(toLight);
        float[] axis = {toLight[0] / distance, toLight[1] / distance, toLight[2] / distance};
        return Paths.lit(new float[] {x, y, z}, axis, distance);
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
