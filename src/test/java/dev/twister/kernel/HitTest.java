package dev.twister.kernel;

import static org.assertj.core.api.Assertions.assertThat;

import dev.twister.world.hierarchy.SphereHierarchy;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class HitTest {
    /** The light behind, the ground below, and three spheres ahead, two of them at the same place. */
    private static final float[] PLACES = {0, 0, -9, 1, 0, -3, 0, 100, 0, 0, 8, 1, 0, 0, 5, 1, 0, 0, 5, 1};

    private static final int BODIES = 5;

    @ParameterizedTest
    @ValueSource(ints = {0, Variant.WALK})
    void closestWinsAndTheLowerIndexOnATie(int variant) {
        float[] path = Paths.ray(new float[3], new float[] {0, 0, 1}, Layout.NOTHING);
        assertThat(find(path, variant)).isEqualTo(3);
        assertThat(path[Layout.DISTANCE]).isEqualTo(4f);
    }

    @ParameterizedTest
    @ValueSource(ints = {0, Variant.WALK})
    void bodyThatTheRayLeavesIsIgnored(int variant) {
        assertThat(find(Paths.ray(new float[3], new float[] {0, 0, 1}, 3), variant))
                .isEqualTo(4);
    }

    @ParameterizedTest
    @ValueSource(ints = {0, Variant.WALK})
    void lightIsABodyToo(int variant) {
        assertThat(find(Paths.ray(new float[3], new float[] {0, 0, -1}, Layout.NOTHING), variant))
                .isEqualTo(Layout.LIGHT);
    }

    @ParameterizedTest
    @ValueSource(ints = {0, Variant.WALK})
    void nothingIsBeyondTheLight(int variant) {
        assertThat(find(Paths.ray(new float[3], new float[] {0, 0, -1}, Layout.LIGHT), variant))
                .isEqualTo(Layout.NOTHING);
    }

    @ParameterizedTest
    @ValueSource(ints = {0, Variant.WALK})
    void groundIsBelow(int variant) {
        assertThat(find(Paths.ray(new float[3], new float[] {0, -1, 0}, Layout.NOTHING), variant))
                .isEqualTo(Layout.PLANE);
    }

    private static int find(float[] path, int variant) {
        return Hit.find(
                path,
                new float[Layout.SCRATCH_LENGTH],
                Paths.frame(BODIES),
                SphereHierarchy.of(PLACES, BODIES, new int[0], 1),
                new float[0],
                new float[0],
                variant);
    }
}
