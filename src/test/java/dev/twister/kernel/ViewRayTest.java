package dev.twister.kernel;

import static org.assertj.core.api.Assertions.assertThat;

import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.IntRange;
import org.junit.jupiter.api.Test;

class ViewRayTest {
    @Property(seed = "20261121")
    void middleColumnOfAnEvenWidthIsExactlyZero(
            @ForAll @IntRange(min = 1, max = 8192) int halfWidth, @ForAll @IntRange(min = 1, max = 16384) int height) {
        assertThat(ViewRay.u(halfWidth, 2 * halfWidth, height)).isZero();
    }

    @Property(seed = "20261121")
    void middleRowOfAnEvenHeightIsExactlyZero(
            @ForAll @IntRange(min = 1, max = 16384) int width, @ForAll @IntRange(min = 1, max = 8192) int halfHeight) {
        assertThat(ViewRay.v(halfHeight, width, 2 * halfHeight)).isZero();
    }

    @Test
    void wideViewportReachesPastOneToTheSides() {
        assertThat(ViewRay.u(0, 1280, 720)).isEqualTo(-1280f / 720f);
        assertThat(ViewRay.v(0, 1280, 720)).isEqualTo(1f);
        assertThat(ViewRay.v(720, 1280, 720)).isEqualTo(-1f);
    }

    @Test
    void tallViewportReachesPastOneUpAndDown() {
        assertThat(ViewRay.u(0, 300, 600)).isEqualTo(-1f);
        assertThat(ViewRay.u(300, 300, 600)).isEqualTo(1f);
        assertThat(ViewRay.v(0, 300, 600)).isEqualTo(2f);
    }
}
