package dev.twister.kernel;

import static org.assertj.core.api.Assertions.assertThat;

import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.IntRange;
import org.junit.jupiter.api.Test;

class CameraRayTest {
    @Property(seed = "20261121")
    void middleColumnOfAnEvenWidthIsExactlyZero(
            @ForAll @IntRange(min = 1, max = 8192) int halfWidth, @ForAll @IntRange(min = 1, max = 16384) int height) {
        assertThat(CameraRay.u(halfWidth, 2 * halfWidth, height)).isZero();
    }

    @Property(seed = "20261121")
    void middleRowOfAnEvenHeightIsExactlyZero(
            @ForAll @IntRange(min = 1, max = 16384) int width, @ForAll @IntRange(min = 1, max = 8192) int halfHeight) {
        assertThat(CameraRay.v(halfHeight, width, 2 * halfHeight)).isZero();
    }

    @Test
    void wideViewportReachesPastOneToTheSides() {
        assertThat(CameraRay.u(0, 1280, 720)).isEqualTo(-1280f / 720f);
        assertThat(CameraRay.v(0, 1280, 720)).isEqualTo(1f);
        assertThat(CameraRay.v(720, 1280, 720)).isEqualTo(-1f);
    }

    @Test
    void tallViewportReachesPastOneUpAndDown() {
        assertThat(CameraRay.u(0, 300, 600)).isEqualTo(-1f);
        assertThat(CameraRay.u(300, 300, 600)).isEqualTo(1f);
        assertThat(CameraRay.v(0, 300, 600)).isEqualTo(2f);
    }
}
