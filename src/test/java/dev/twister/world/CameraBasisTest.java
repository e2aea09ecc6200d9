package dev.twister.world;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import dev.twister.kernel.Layout;
import dev.twister.scene.Camera;
import dev.twister.scene.Vector3;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class CameraBasisTest {
    @ParameterizedTest
    @CsvSource({
        "0, 0, 0, 0, 1",
        "90, 0, 1, 0, 0",
        "-90, 0, -1, 0, 0",
        "180, 0, 0, 0, -1",
        "0, 90, 0, -1, 0",
        "0, -90, 0, 1, 0",
        "90, 45, 0.70710677, -0.70710677, 0"
    })
    void positiveYawLooksRightAndPositivePitchDown(double yaw, double pitch, float x, float y, float z) {
        assertDirection(basis(yaw, pitch, 50), Layout.CAMERA_FORWARD, x, y, z);
    }

    @Test
    void rightAndUpAreTheAxesWhereTheCameraLooksForward() {
        float[] basis = basis(0, 0, 50);
        assertDirection(basis, Layout.CAMERA_RIGHT, 1, 0, 0);
        assertDirection(basis, Layout.CAMERA_UP, 0, 1, 0);
    }

    @Test
    void lookingStraightDownUpIsForward() {
        assertDirection(basis(0, 90, 50), Layout.CAMERA_UP, 0, 0, 1);
    }

    @Test
    void rightStaysLevel() {
        assertThat(basis(33, -71, 50)[Layout.CAMERA_RIGHT + 1]).isZero();
    }

    @Test
    void basisIsOrthonormal() {
        float[] basis = basis(33, -71, 50);
        int[] directions = {Layout.CAMERA_RIGHT, Layout.CAMERA_UP, Layout.CAMERA_FORWARD};
        for (int one : directions) {
            for (int other : directions) {
                float dot = basis[one] * basis[other]
                        + basis[one + 1] * basis[other + 1]
                        + basis[one + 2] * basis[other + 2];
                assertThat(dot).isCloseTo(one == other ? 1f : 0f, within(1e-6f));
            }
        }
    }

    @ParameterizedTest
    @CsvSource({"90, 1", "1, 114.58865", "179, 0.008726868"})
    void eyeIsFartherBehindANarrowerView(double fieldOfView, float distance) {
        assertThat(basis(0, 0, fieldOfView)[Layout.CAMERA_EYE_DISTANCE]).isCloseTo(distance, within(1e-6f * distance));
    }

    private static float[] basis(double yaw, double pitch, double fieldOfView) {
        return CameraBasis.of(Camera.of(new Vector3(1, 2, 3), yaw, pitch, fieldOfView));
    }

    private static void assertDirection(float[] basis, int at, float x, float y, float z) {
        assertThat(new float[] {basis[at], basis[at + 1], basis[at + 2]})
                .containsExactly(new float[] {x, y, z}, within(1e-7f));
    }
}
