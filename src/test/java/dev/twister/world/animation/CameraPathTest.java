package dev.twister.world.animation;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import dev.twister.scene.Camera;
import dev.twister.scene.CameraKeyframe;
import dev.twister.scene.Material;
import dev.twister.scene.Sphere;
import dev.twister.scene.Vector3;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;

class CameraPathTest {
    private static final Camera CAMERA =
            Camera.of(new Vector3(1, 2, 3), 10, 20, 50).withFocusDistance(4);
    private static final CameraKeyframe START = key(1, 0, 0, 40);
    private static final CameraKeyframe MIDDLE = key(2, 4, 90, 60);
    private static final CameraKeyframe END = key(5, 10, 360, 50);
    private static final Camera MOVING = CAMERA.withKeyframes(List.of(START, MIDDLE, END));

    @Test
    void withoutKeyframesItStandsStill() {
        assertThat(CameraPath.at(CAMERA, 7)).isEqualTo(CAMERA);
    }

    @Test
    void goesThroughEveryKeyframe() {
        for (CameraKeyframe key : MOVING.keyframes()) {
            Camera there = CameraPath.at(MOVING, key.seconds());
            assertThat(there.position()).isEqualTo(key.position());
            assertThat(there.yawDegrees()).isEqualTo(key.yawDegrees());
            assertThat(there.fieldOfViewDegrees())
                    .isEqualTo(key.fieldOfViewDegrees().orElseThrow());
            assertThat(there.focusDistance()).isEqualTo(4);
        }
    }

    @Test
    void standsStillBeforeTheFirstKeyframeAndAfterTheLast() {
        assertThat(CameraPath.at(MOVING, 0)).isEqualTo(CameraPath.at(MOVING, 1));
        assertThat(CameraPath.at(MOVING, 99)).isEqualTo(CameraPath.at(MOVING, 5));
    }

    @Test
    void itsSpeedDoesNotJumpAtAKeyframe() {
        double step = 1e-4;
        double before = (x(2) - x(2 - step)) / step;
        double after = (x(2 + step) - x(2)) / step;

        assertThat(after).isCloseTo(before, within(0.01));
        // From the first keyframe to the last: 10 m in 4 s.
        assertThat(after).isCloseTo(2.5, within(0.01));
    }

    @Test
    void evenKeyframesOnALineAreEvenMotion() {
        Camera even = CAMERA.withKeyframes(List.of(key(0, 0, 0, 50), key(1, 2, 0, 50), key(2, 4, 0, 50)));

        assertThat(CameraPath.at(even, 0.3).position().x()).isCloseTo(0.6, within(1e-12));
        assertThat(CameraPath.at(even, 1.7).position().x()).isCloseTo(3.4, within(1e-12));
    }

    @Test
    void neverLeavesTheRangeOfAngles() {
        Camera steep = CAMERA.withKeyframes(List.of(pitched(0, 90), pitched(1, 90), pitched(2, -90), pitched(3, -90)));

        for (int i = 0; i <= 300; i++) {
            assertThat(CameraPath.at(steep, i / 100.0).pitchDegrees()).isBetween(-90.0, 90.0);
        }
    }

    @Test
    void aCircleKeepsItsDistanceAndLooksAtTheSame() {
        List<Sphere> spheres = List.of(sphere(2, 5), sphere(4, 7));

        Camera quarter = CameraPath.onCircle(CAMERA, spheres, 0.25);

        // 2 to the left of the center (3, 6) and 3 in front of it.
        assertThat(quarter.position().x()).isCloseTo(0, within(1e-12));
        assertThat(quarter.position().y()).isEqualTo(2);
        assertThat(quarter.position().z()).isCloseTo(8, within(1e-12));
        assertThat(quarter.yawDegrees()).isEqualTo(100);
        assertThat(CameraPath.onCircle(CAMERA, spheres, 3)).isEqualTo(CAMERA);
    }

    private static double x(double seconds) {
        return CameraPath.at(MOVING, seconds).position().x();
    }

    private static CameraKeyframe key(double seconds, double x, double yaw, double fieldOfView) {
        return new CameraKeyframe(seconds, new Vector3(x, 1, 0), yaw, 5, Optional.of(fieldOfView), Optional.empty());
    }

    private static CameraKeyframe pitched(double seconds, double pitch) {
        return new CameraKeyframe(seconds, new Vector3(0, 1, 0), 0, pitch, Optional.empty(), Optional.empty());
    }

    private static Sphere sphere(double x, double z) {
        return Sphere.of(new Vector3(x, 1, z), 1, Material.DEFAULT.color(), 0);
    }
}
