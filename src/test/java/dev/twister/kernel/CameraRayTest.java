package dev.twister.kernel;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Arrays;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.FloatRange;
import net.jqwik.api.constraints.IntRange;
import org.assertj.core.data.Offset;
import org.junit.jupiter.api.Test;

class CameraRayTest {
    private static final Offset<Float> CLOSE = within(1e-6f);

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

    /** Looks along z. */
    private static float[] frame(int projection, int width, int height) {
        float[] frame = new float[Layout.DISC];
        frame[Layout.CAMERA_RIGHT] = 1;
        frame[Layout.CAMERA_UP + 1] = 1;
        frame[Layout.CAMERA_FORWARD + 2] = 1;
        frame[Layout.CAMERA_POSITION] = 5;
        frame[Layout.CAMERA_PROJECTION] = projection;
        frame[Layout.CAMERA_VIEW_HEIGHT] = 4;
        frame[Layout.CAMERA_HALF_FIELD] = 0.25f;
        frame[Layout.WIDTH] = width;
        frame[Layout.HEIGHT] = height;
        return frame;
    }

    private static float[] ray(int projection, int width, int height, float x, float y) {
        float[] path = new float[Layout.PATH_LENGTH];
        CameraRay.start(path, x, y, frame(projection, width, height));
        return path;
    }

    private static float[] direction(int projection, int width, int height, float x, float y) {
        return Arrays.copyOfRange(ray(projection, width, height, x, y), Layout.DIRECTION, Layout.DIRECTION + 3);
    }

    @Test
    void parallelRaysStartOnThePlaneOfTheCamera() {
        float[] path = ray(CameraRay.ORTHOGRAPHIC, 300, 200, 300, 0);

        assertThat(Arrays.copyOfRange(path, Layout.ORIGIN, Layout.ORIGIN + 3)).containsExactly(5 + 3, 2, 0);
        assertThat(Arrays.copyOfRange(path, Layout.DIRECTION, Layout.DIRECTION + 3))
                .containsExactly(0, 0, 1);
    }

    @Test
    void aFisheyeOfHalfTheSphereEndsAtRightAngles() {
        assertThat(direction(CameraRay.FISHEYE, 300, 200, 150, 100)).containsExactly(0, 0, 1);
        assertThat(direction(CameraRay.FISHEYE, 300, 200, 250, 100)).containsExactly(new float[] {1, 0, 0}, CLOSE);
        assertThat(direction(CameraRay.FISHEYE, 300, 200, 150, 50))
                .containsExactly(new float[] {0, (float) Math.sqrt(0.5), (float) Math.sqrt(0.5)}, CLOSE);
    }

    /** A panorama can be the sky of another scene. */
    @Property(seed = "20261128", tries = 200)
    void aPanoramaIsReadAsASkyIs(
            @ForAll @FloatRange(min = 0.01f, max = 0.99f) float across,
            @ForAll @FloatRange(min = 0.01f, max = 0.99f) float down) {
        float[] seen = direction(CameraRay.PANORAMA, 400, 200, 400 * across, 200 * down);

        float column = SkyLookup.column(seen[0], seen[2], 0, 400);
        assertThat(Math.abs((column + 0.5f) - 400 * across) % 400).isLessThan(0.02f);
        assertThat(SkyLookup.row(seen[0], seen[1], seen[2], 200) + 0.5f).isCloseTo(200 * down, within(0.02f));
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
