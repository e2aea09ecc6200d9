package dev.twister.kernel;

import static org.assertj.core.api.Assertions.assertThat;

import dev.twister.world.SphereHierarchy;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class HitTest {
    /** The light behind, the ground below, and three spheres ahead, two of them at the same place. */
    private static final float[] PLACES = {0, 0, -9, 1, 0, -3, 0, 100, 0, 0, 8, 1, 0, 0, 5, 1, 0, 0, 5, 1};

    private static final int BODIES = 5;

    @ParameterizedTest
    @ValueSource(ints = {Hit.ALL, Hit.WALK})
    void closestWinsAndTheLowerIndexOnATie(int search) {
        float[] path = Paths.ray(new float[3], new float[] {0, 0, 1}, Layout.NOTHING);
        assertThat(find(path, search)).isEqualTo(3);
        assertThat(path[Layout.DISTANCE]).isEqualTo(4f);
    }

    @ParameterizedTest
    @ValueSource(ints = {Hit.ALL, Hit.WALK})
    void bodyThatTheRayLeavesIsIgnored(int search) {
        assertThat(find(Paths.ray(new float[3], new float[] {0, 0, 1}, 3), search))
                .isEqualTo(4);
    }

    @ParameterizedTest
    @ValueSource(ints = {Hit.ALL, Hit.WALK})
    void lightIsABodyToo(int search) {
        assertThat(find(Paths.ray(new float[3], new float[] {0, 0, -1}, Layout.NOTHING), search))
                .isEqualTo(Layout.LIGHT);
    }

    @ParameterizedTest
    @ValueSource(ints = {Hit.ALL, Hit.WALK})
    void nothingIsBeyondTheLight(int search) {
        assertThat(find(Paths.ray(new float[3], new float[] {0, 0, -1}, Layout.LIGHT), search))
                .isEqualTo(Layout.NOTHING);
    }

    @ParameterizedTest
    @ValueSource(ints = {Hit.ALL, Hit.WALK})
    void groundIsBelow(int search) {
        assertThat(find(Paths.ray(new float[3], new float[] {0, -1, 0}, Layout.NOTHING), search))
                .isEqualTo(Layout.PLANE);
    }

    private static int find(float[] path, int search) {
        float[] hierarchy = SphereHierarchy.of(PLACES, BODIES, 1);
        return Hit.find(
                path,
                PLACES,
                new float[0],
                hierarchy,
                new float[0],
                BODIES,
                new float[Layout.SCRATCH_LENGTH],
                search,
                Layout.NO_MESHES,
                Material.PLAIN,
                Aspect.FULL);
    }
}
