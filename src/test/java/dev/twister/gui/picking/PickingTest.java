package dev.twister.gui.picking;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import dev.twister.gui.edit.Axis;
import dev.twister.gui.edit.BodyEdits;
import dev.twister.gui.edit.Scenes;
import dev.twister.kernel.Layout;
import dev.twister.scene.Camera;
import dev.twister.scene.Light;
import dev.twister.scene.Scene;
import dev.twister.scene.Vector3;
import dev.twister.scene.light.Lights;
import dev.twister.scene.property.CameraProperties;
import dev.twister.world.FrameInput;
import dev.twister.world.SceneMeshes;
import java.util.List;
import java.util.Optional;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.DoubleRange;
import org.junit.jupiter.api.Test;

/** What the pointer finds, takes and inserts. */
class PickingTest {
    private static final double TAN = Math.tan(Math.toRadians(30));
    private final Scene scene = Scenes.scene();
    private final FrameInput input = Scenes.input(scene);

    /** Where a place appears, by the pinhole camera's textbook equation. */
    private static double[] pixelOf(Vector3 place) {
        double depth = place.z() + 10;
        double half = Scenes.HEIGHT / 2.0;
        double x = Scenes.WIDTH / 2.0 + half * place.x() / (depth * TAN);
        double y = half - half * (place.y() - 2) / (depth * TAN);
        return new double[] {x, y};
    }

    private int bodyAt(Vector3 place) {
        double[] pixel = pixelOf(place);
        return PointerRay.bodyAt(input, pixel[0], pixel[1]);
    }

    @Test
    void bodiesAreFoundWhereTheyAreSeen() {
        assertThat(bodyAt(new Vector3(0, 2, 0))).isEqualTo(Layout.FIRST_SPHERE);
        assertThat(bodyAt(new Vector3(4, 2, 2))).isEqualTo(Layout.FIRST_SPHERE + 1);
        assertThat(bodyAt(scene.lights().first().position())).isEqualTo(Layout.LIGHT);
        assertThat(bodyAt(new Vector3(0, 0, -5))).isEqualTo(Layout.PLANE);
        assertThat(bodyAt(new Vector3(0, 7, 0))).isEqualTo(Layout.NOTHING);
    }

    @Test
    void farAwayASphereIsDraggedAndInsertedAsWell() {
        double far = 900_000;
        Camera camera = scene.camera();
        Vector3 up = new Vector3(
                camera.position().x(),
                camera.position().y() + far,
                camera.position().z());
        Scene moved = scene.withCamera(camera.withPosition(up))
                .withGround(scene.ground().withHeight(scene.ground().height() + far));
        FrameInput there = Scenes.input(moved);
        Scene empty = scene.withSpheres(List.of());
        Scene emptyThere = moved.withSpheres(List.of());
        Vector3 near =
                NewBodies.sphere(Scenes.input(empty), empty, SceneMeshes.NONE).position();
        Vector3 inserted = NewBodies.sphere(Scenes.input(emptyThere), emptyThere, SceneMeshes.NONE)
                .position();
        assertThat(inserted.y() - far).isCloseTo(near.y(), within(1e-3));
        Vector3 center = new Vector3(1, far + 3, 2);
        Vector3 dragged = BodyDrag.start(there, center, center, 50, 40).placeAt(there, 50, 40);
        assertThat(dragged.y()).isCloseTo(center.y(), within(1e-6));
        assertThat(BodyDrag.start(there, center, center, 50, 40)
                                .placeAt(there, 60, 40)
                                .x()
                        - dragged.x())
                .isCloseTo(
                        BodyDrag.start(input, new Vector3(1, 3, 2), new Vector3(1, 3, 2), 50, 40)
                                        .placeAt(input, 60, 40)
                                        .x()
                                - 1,
                        within(1e-3));
    }

    @Test
    void aLensIsFocusedAlongTheForwardAxis() {
        double[] side = pixelOf(new Vector3(3, 0, -4));
        assertThat(PointerRay.focusDistance(input, side[0], side[1])).isCloseTo(6, within(1e-4));
        double[] sky = pixelOf(new Vector3(0, 7, 0));
        assertThat(PointerRay.focusDistance(input, sky[0], sky[1]))
                .isEqualTo(CameraProperties.FOCUS_DISTANCE.range().max());
    }

    @Test
    void aSphereEndsAtItsRim() {
        double distance = 10;
        double rim = distance * Math.tan(Math.asin(1.5 / distance));
        assertThat(bodyAt(new Vector3(0.99 * rim, 2, 0))).isEqualTo(Layout.FIRST_SPHERE);
        assertThat(bodyAt(new Vector3(1.01 * rim, 2, 0))).isNotEqualTo(Layout.FIRST_SPHERE);
    }

    @Property(seed = "20261121", tries = 200)
    void aDraggedSphereStaysUnderThePointer(
            @ForAll @DoubleRange(min = 0, max = Scenes.WIDTH) double x,
            @ForAll @DoubleRange(min = 0, max = Scenes.HEIGHT) double y,
            @ForAll @DoubleRange(min = -180, max = 180) double yaw,
            @ForAll @DoubleRange(min = -80, max = 80) double pitch) {
        Camera camera = Camera.of(new Vector3(3, 4, -2), yaw, pitch, 70);
        FrameInput view = Scenes.input(scene.withCamera(camera));
        Vector3 forward = forward(camera);
        Vector3 center = new Vector3(3 + 6 * forward.x(), 4 + 6 * forward.y(), -2 + 6 * forward.z());
        // The sphere lies in the middle of the picture, where it is taken.
        BodyDrag drag = BodyDrag.start(view, center, center, Scenes.WIDTH / 2.0, Scenes.HEIGHT / 2.0);
        Vector3 moved = drag.placeAt(view, x, y);
        double depth = (moved.x() - 3) * forward.x() + (moved.y() - 4) * forward.y() + (moved.z() + 2) * forward.z();
        assertThat(depth).isCloseTo(6, within(1e-4));
        Scene dragged = BodyEdits.moved(scene.withCamera(camera), Layout.FIRST_SPHERE, moved);
        Scene alone = dragged.withSpheres(dragged.spheres().subList(0, 1)).withLights(Lights.of(farAway()));
        // Only the plane may hide it.
        assertThat(PointerRay.bodyAt(Scenes.input(alone), x, y)).isIn(Layout.FIRST_SPHERE, Layout.PLANE);
    }

    private Light farAway() {
        return scene.lights().first().withPosition(new Vector3(0, 1e5, 0)).withRadius(0.5);
    }

    private static Vector3 forward(Camera camera) {
        double yaw = Math.toRadians(camera.yawDegrees());
        double pitch = Math.toRadians(camera.pitchDegrees());
        return new Vector3(Math.cos(pitch) * Math.sin(yaw), -Math.sin(pitch), Math.cos(pitch) * Math.cos(yaw));
    }

    @Test
    void takingHoldDoesNotMoveIt() {
        Vector3 center = scene.spheres().getFirst().position();
        BodyDrag drag = BodyDrag.start(input, center, center, 52, 30);
        Vector3 still = drag.placeAt(input, 52, 30);
        assertThat(still.x()).isCloseTo(center.x(), within(1e-6));
        assertThat(still.y()).isCloseTo(center.y(), within(1e-6));
        assertThat(still.z()).isCloseTo(center.z(), within(1e-6));
    }

    @Test
    void aDragMovesByWhatThePointerMoves() {
        BodyDrag drag = BodyDrag.start(input, new Vector3(0, 2, 0), new Vector3(0, 2, 0), 48, 32);
        Vector3 moved = drag.placeAt(input, 48 + 16, 32);
        assertThat(moved.x()).isCloseTo(10 * TAN * 16 / 32, within(1e-4));
        assertThat(moved.y()).isCloseTo(2, within(1e-4));
        assertThat(moved.z()).isCloseTo(0, within(1e-4));
    }

    @Test
    void alongAnAxisABodyFollowsThePointerAndStaysOnTheAxis() {
        Vector3 place = new Vector3(0, 2, 0);
        double[] start = pixelOf(place);
        BodyDrag drag = BodyDrag.start(input, place, place, start[0], start[1]);
        double[] right = pixelOf(new Vector3(3, 2.5, 0));
        Vector3 along = drag.placeAlong(Axis.X, input, right[0], right[1]);
        assertThat(along.x()).isCloseTo(3, within(0.05));
        assertThat(along.y()).isEqualTo(2);
        assertThat(along.z()).isZero();
        // The axis is seen end on.
        assertThat(drag.placeAlong(Axis.Z, input, start[0], start[1])).isEqualTo(place);

        Vector3 beside = new Vector3(3, 2, 0);
        double[] hold = pixelOf(beside);
        BodyDrag other = BodyDrag.start(input, beside, beside, hold[0], hold[1]);
        double[] farther = pixelOf(new Vector3(3, 2, 4));
        assertThat(other.placeAlong(Axis.Z, input, farther[0], farther[1]).z()).isCloseTo(4, within(1e-3));
    }

    @Test
    void snappingRoundsToHalfMeters() {
        Vector3 place = new Vector3(1.2, -0.2, 3.3);
        assertThat(BodyDrag.snapped(place, Optional.empty())).isEqualTo(new Vector3(1, 0, 3.5));
        assertThat(BodyDrag.snapped(place, Optional.of(Axis.X))).isEqualTo(new Vector3(1, -0.2, 3.3));
    }
}
