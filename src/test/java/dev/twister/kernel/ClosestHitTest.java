package dev.twister.kernel;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

class ClosestHitTest {
    /** The light behind, the ground below, and three spheres ahead, of which two are in one place. */
    private static final float[] POSITIONS = {0, 0, -9, 0, -3, 0, 0, 0, 8, 0, 0, 5, 0, 0, 5};

    private static final float[] SIZES = {1, 100, 1, 1, 1};

    @Test
    void closestWinsAndTheLowerIndexOnATie() {
        assertThat(bodyAhead(Layout.NOTHING, 1)).isEqualTo(3);
    }

    @Test
    void bodyThatTheRayLeavesIsIgnored() {
        assertThat(bodyAhead(3, 1)).isEqualTo(4);
    }

    @Test
    void lightIsABodyToo() {
        assertThat(bodyAhead(Layout.NOTHING, -1)).isEqualTo(Layout.LIGHT);
    }

    @Test
    void nothingIsBeyondTheLight() {
        assertThat(bodyAhead(Layout.LIGHT, -1)).isEqualTo(Layout.NOTHING);
    }

    @Test
    void groundIsBelow() {
        assertThat(ClosestHit.body(0, 0, 0, 0, -1, 0, Layout.NOTHING, POSITIONS, SIZES, SIZES.length))
                .isEqualTo(Layout.PLANE);
    }

    private static int bodyAhead(int ignored, float directionZ) {
        return ClosestHit.body(0, 0, 0, 0, 0, directionZ, ignored, POSITIONS, SIZES, SIZES.length);
    }
}
