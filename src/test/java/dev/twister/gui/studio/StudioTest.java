package dev.twister.gui.studio;

import static org.assertj.core.api.Assertions.assertThat;

import dev.twister.engine.JvmEngines;
import dev.twister.gui.WindowScenes;
import dev.twister.gui.drawing.DrawingRequest;
import dev.twister.gui.drawing.RefinementGoal;
import dev.twister.gui.edit.BodyEdits;
import dev.twister.kernel.Layout;
import dev.twister.scene.Camera;
import dev.twister.scene.CameraView;
import dev.twister.scene.Keyframe;
import dev.twister.scene.Scene;
import dev.twister.scene.Sphere;
import dev.twister.scene.Track;
import dev.twister.scene.TrackTarget;
import dev.twister.scene.Vector3;
import dev.twister.world.animation.CameraMotion;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.LockSupport;
import java.util.function.Predicate;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

/** The studio without a window. */
class StudioTest {
    private static final Path FILE = Path.of("test.json");
    private static final int SIDE = 32;

    private final Scene scene = WindowScenes.tiny();
    private final Studio studio = start(scene);

    private static Studio start(Scene scene) {
        return Studio.start(new OpenedScene(FILE, scene), JvmEngines.parallel(), JvmEngines.parallel());
    }

    @AfterEach
    void close() {
        studio.close();
    }

    @Test
    void aSceneThatIsOpenedIsDrawnAsAnotherOneAndAnEditAsTheSame() {
        studio.setViewSize(SIDE, SIDE);
        DrawingRequest first = awaitRequest(_ -> true);

        Scene shadowed = scene.withRendering(scene.rendering().withShadowSamples(2));
        studio.edit("shadows", _ -> shadowed);
        DrawingRequest edited = awaitRequest(request -> request.scene().equals(shadowed));
        assertThat(edited.document()).isEqualTo(first.document());

        studio.show(new OpenedScene(FILE, scene));
        DrawingRequest opened = awaitRequest(request -> request.scene().equals(scene));
        assertThat(opened.document()).isNotEqualTo(first.document());
    }

    @Test
    void aTimeOfTheFilmShowsWhatHasTracksAsTheySayAndIsNoEdit() {
        Track exposure = Track.of(TrackTarget.RENDERING, "exposure", Keyframe.of(0, -1), Keyframe.of(4, 3));
        studio.edit("animate", now -> now.withTracks(List.of(exposure)));
        studio.film().goTo(2);

        assertThat(studio.scene().rendering().exposure()).isEqualTo(1);
        assertThat(studio.document().editsProperty().get().undoable()).contains("animate");
    }

    @Test
    void undoShowsThePresentTimeOfTheFilm() {
        Track exposure = Track.of(TrackTarget.RENDERING, "exposure", Keyframe.of(0, -1), Keyframe.of(4, 3));
        studio.edit("animate", now -> now.withTracks(List.of(exposure)));
        studio.edit("shadows", now -> now.withRendering(now.rendering().withShadowSamples(2)));
        studio.film().goTo(4);
        studio.undo();

        assertThat(studio.scene().rendering().exposure()).isEqualTo(3);
    }

    @Test
    void anEditOfAnotherBodyIsAnotherStep() {
        Sphere first = scene.spheres().getFirst();
        studio.selection().select(Layout.FIRST_SPHERE);
        studio.edit("move", now -> BodyEdits.moved(now, Layout.FIRST_SPHERE, new Vector3(0, 7, 0)));
        Scene moved = studio.scene();
        // By a key, while the mouse button is down.
        studio.selection().select(Layout.FIRST_SPHERE + 1);
        studio.edit("move", now -> BodyEdits.moved(now, Layout.FIRST_SPHERE + 1, first.position()));
        studio.undo();
        assertThat(studio.scene().spheres()).isEqualTo(moved.spheres());
    }

    @Test
    void theCameraOfTheFirstSceneAndOfOneThatIsOpenedIsLiftedOverThePlane() {
        Camera usual = scene.camera();
        Scene buried = scene.withCamera(
                usual.withPosition(new Vector3(0, -5, -8)).withYawDegrees(0).withPitchDegrees(0));
        double lowest = scene.ground().height() + CameraMotion.CLEARANCE_METERS;
        try (Studio first = start(buried)) {
            assertThat(first.scene().camera().position()).isEqualTo(new Vector3(0, lowest, -8));
            assertThat(first.document().toSave().scene()).isEqualTo(first.scene());
            assertThat(first.document().editsProperty().get().changed()).isFalse();
        }

        studio.show(new OpenedScene(FILE, buried));
        assertThat(studio.scene().camera().position()).isEqualTo(new Vector3(0, lowest, -8));
    }

    @Test
    void cameraThatMovesKeepsItsLens() {
        studio.edit("lens", now -> now.withCamera(now.camera().withAperture(0.1).withFocusDistance(3)));
        studio.moveCamera(camera -> camera.withYawDegrees(90));
        studio.cameraControl().goHome();
        assertThat(studio.scene().camera())
                .isEqualTo(scene.camera().withAperture(0.1).withFocusDistance(3));
        studio.undo();
        assertThat(studio.scene().camera()).isEqualTo(scene.camera());
    }

    @Test
    void aViewHasALensOfItsOwn() {
        studio.edit("lens", now -> now.withCamera(now.camera().withAperture(0.1)));
        studio.cameraControl().keepView(1);
        studio.edit("lens", now -> now.withCamera(now.camera().withAperture(0.2)));
        studio.moveCamera(camera -> camera.withYawDegrees(90));

        studio.cameraControl().recallView(1);

        assertThat(studio.scene().camera()).isEqualTo(scene.camera().withAperture(0.1));
        assertThat(studio.document().editsProperty().get().undoable()).contains("lens");
    }

    @Test
    void viewsAreEditsOfTheSceneAndDrawNothing() {
        studio.setViewSize(SIDE, SIDE);
        long requests = studio.lastRequest();
        for (int digit = 1; digit <= 9; digit++) {
            studio.cameraControl().keepView(digit);
        }
        studio.cameraControl().keepView(0);
        studio.cameraControl().keepView(0);

        assertThat(studio.scene().views()).hasSize(10);
        assertThat(studio.scene().views().get(9)).isEqualTo(new CameraView("View 10", scene.camera()));
        assertThat(studio.lastRequest()).isEqualTo(requests);
        assertThat(studio.document().editsProperty().get().changed()).isTrue();
        assertThat(studio.document().editsProperty().get().undoable()).contains("add view");
        studio.undo();
        assertThat(studio.scene().views()).hasSize(9);
        assertThat(studio.document().toSave().scene().views()).hasSize(9);
    }

    @Test
    void aNumberKeyReplacesItsViewOrAddsOneBehindTheLast() {
        studio.cameraControl().keepView(5);
        assertThat(studio.noticeProperty().get()).isEqualTo("View kept under 1: View 1");
        studio.moveCamera(camera -> camera.withYawDegrees(90));
        studio.cameraControl().keepView(1);

        assertThat(studio.scene().views())
                .containsExactly(new CameraView("View 1", scene.camera().withYawDegrees(90)));
        assertThat(studio.document().editsProperty().get().undoable()).contains("update view");
    }

    @Test
    void aPictureWithALensGathersMoreSamples() {
        studio.setViewSize(SIDE, SIDE);
        assertThat(awaitRequest(_ -> true).refinement().samples()).isEqualTo(RefinementGoal.SHARP);
        studio.edit("aperture", now -> now.withCamera(now.camera().withAperture(0.1)));
        assertThat(awaitRequest(request -> request.scene().camera().aperture() > 0)
                        .refinement()
                        .samples())
                .isEqualTo(RefinementGoal.NOISY);
    }

    private DrawingRequest awaitRequest(Predicate<DrawingRequest> wanted) {
        long end = System.nanoTime() + TimeUnit.MINUTES.toNanos(5);
        studio.pulse(System.nanoTime());
        while (studio.pictureProperty()
                .get()
                .filter(picture -> wanted.test(picture.request()))
                .isEmpty()) {
            assertThat(System.nanoTime()).as("the time is over").isLessThan(end);
            LockSupport.parkNanos(TimeUnit.MILLISECONDS.toNanos(1));
            studio.pulse(System.nanoTime());
        }
        return studio.pictureProperty().get().orElseThrow().request();
    }
}
