package dev.twister.world.animation;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import dev.twister.kernel.Layout;
import dev.twister.scene.Camera;
import dev.twister.scene.Ground;
import dev.twister.scene.Rgb;
import dev.twister.scene.Vector3;
import dev.twister.world.CameraBasis;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.DoubleRange;
import net.jqwik.api.constraints.IntRange;
import org.junit.jupiter.api.Test;

class CameraMotionTest {
    private static final Ground PLANE = Ground.of(48, -10, new Rgb(1, 1, 1), new Rgb(0, 0, 0), 0);
    private static final Camera CAMERA = Camera.of(new Vector3(1, 2, 3), 0, 20, 60);
    private static final Walk FORWARD = new Walk(0, 0, 1, false);

    @Test
    void turnsAsFarInOneStepAsInMany() {
        Turn turn = new Turn(1, -0.5, false);
        Camera once = CameraMotion.turn(CAMERA, turn, 0.5);
        Camera often = CAMERA;
        for (int step = 0; step < 10; step++) {
            often = CameraMotion.turn(often, turn, 0.05);
        }

        assertThat(once.yawDegrees() - CAMERA.yawDegrees())
                .isCloseTo(0.5 * CameraMotion.TURN_DEGREES_PER_SECOND, within(1e-9));
        assertThat(CAMERA.pitchDegrees() - once.pitchDegrees())
                .isCloseTo(0.25 * CameraMotion.TURN_DEGREES_PER_SECOND, within(1e-9));
        assertThat(often.yawDegrees()).isCloseTo(once.yawDegrees(), within(1e-9));
        assertThat(often.pitchDegrees()).isCloseTo(once.pitchDegrees(), within(1e-9));
        assertThat(CameraMotion.turn(CAMERA, new Turn(1, 0, true), 0.1).yawDegrees() - CAMERA.yawDegrees())
                .isCloseTo(0.1 * CameraMotion.FAST_TURN_DEGREES_PER_SECOND, within(1e-9));
    }

    private static final double TINY = 1e-9;

    @Property(seed = "20261121")
    void asFarAtAnyFrameRate(@ForAll @IntRange(min = 1, max = 500) int framesPerSecond) {
        Camera camera = CAMERA;
        for (int frame = 0; frame < framesPerSecond; frame++) {
            camera = CameraMotion.walk(camera, FORWARD, 1.0 / framesPerSecond, PLANE);
        }

        assertThat(camera.position().z())
                .isCloseTo(CAMERA.position().z() + CameraMotion.WALK_METERS_PER_SECOND, within(1e-6));
        assertThat(camera.position().x()).isEqualTo(CAMERA.position().x());
        assertThat(camera.position().y()).isEqualTo(CAMERA.position().y());
    }

    @Property(seed = "20261121")
    void neverBelowThePlane(
            @ForAll @DoubleRange(min = -1, max = 1) double up,
            @ForAll @DoubleRange(min = 0, max = 1000) double seconds) {
        Camera moved = CameraMotion.walk(CAMERA, new Walk(0.5, up, -1, true), seconds, PLANE);

        assertThat(moved.position().y()).isGreaterThanOrEqualTo(PLANE.height() + CameraMotion.CLEARANCE_METERS);
    }

    @Test
    void walksTheWayItLooks() {
        Camera right = CameraMotion.look(CAMERA, 90, 0);

        Camera moved = CameraMotion.walk(right, FORWARD, 1, PLANE);

        assertThat(moved.position().x())
                .isCloseTo(CAMERA.position().x() + CameraMotion.WALK_METERS_PER_SECOND, within(TINY));
        assertThat(moved.position().z()).isCloseTo(CAMERA.position().z(), within(TINY));
    }

    @Test
    void rightIsWhereTheKernelHasIt() {
        Camera turned = CameraMotion.look(CAMERA, 37, 0);
        float[] basis = CameraBasis.of(turned);

        Camera moved = CameraMotion.walk(turned, new Walk(1, 0, 0, false), 1, PLANE);

        assertThat((moved.position().x() - CAMERA.position().x()) / CameraMotion.WALK_METERS_PER_SECOND)
                .isCloseTo(basis[Layout.CAMERA_RIGHT], within(1e-6));
        assertThat((moved.position().z() - CAMERA.position().z()) / CameraMotion.WALK_METERS_PER_SECOND)
                .isCloseTo(basis[Layout.CAMERA_RIGHT + 2], within(1e-6));
    }

    @Test
    void slantwiseIsNotFaster() {
        Camera moved = CameraMotion.walk(CAMERA, new Walk(1, 1, 1, true), 1, PLANE);

        double meters = Math.hypot(
                Math.hypot(
                        moved.position().x() - CAMERA.position().x(),
                        moved.position().y() - CAMERA.position().y()),
                moved.position().z() - CAMERA.position().z());
        assertThat(meters).isCloseTo(CameraMotion.RUN_METERS_PER_SECOND, within(TINY));
    }

    @Test
    void anglesStayInRange() {
        Camera turned = CameraMotion.look(CAMERA, 350, 1000);

        assertThat(turned.yawDegrees()).isCloseTo(-10, within(TINY));
        assertThat(turned.pitchDegrees()).isEqualTo(90);
        assertThat(CameraMotion.look(CAMERA, 180, -1000))
                .isEqualTo(CAMERA.withYawDegrees(-180).withPitchDegrees(-90));
    }

    @Test
    void theWheelGoesThereAndBack() {
        Camera near = CameraMotion.zoom(CAMERA, 3);

        assertThat(near.fieldOfViewDegrees()).isLessThan(CAMERA.fieldOfViewDegrees());
        assertThat(CameraMotion.zoom(near, -3).fieldOfViewDegrees())
                .isCloseTo(CAMERA.fieldOfViewDegrees(), within(TINY));
        assertThat(CameraMotion.zoom(CAMERA, 1000).fieldOfViewDegrees()).isEqualTo(1);
        assertThat(CameraMotion.zoom(CAMERA, -1000).fieldOfViewDegrees()).isEqualTo(179);
    }

    @Test
    void staysWhereAFileCanHaveIt() {
        Camera moved = CameraMotion.walk(CAMERA, FORWARD, 1e9, PLANE);

        assertThat(moved.position().z()).isEqualTo(1e6);
    }
}
