package dev.twister.gui.edit;

import static org.assertj.core.api.Assertions.assertThat;

import dev.twister.scene.Camera;
import dev.twister.scene.Scene;
import dev.twister.scene.Sphere;
import dev.twister.scene.Vector3;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.IntRange;
import net.jqwik.api.constraints.Size;
import org.junit.jupiter.api.Test;

class SceneHistoryTest {
    private final Scene start = Scenes.scene();
    private final SceneHistory history = new SceneHistory(start);

    private static Scene shadows(Scene scene, int samples) {
        return scene.withRendering(scene.rendering().withShadowSamples(samples));
    }

    private static Scene bounces(Scene scene, int bounces) {
        return scene.withRendering(scene.rendering().withBounces(bounces));
    }

    @Test
    void anEditIsTakenBackAndMadeAgain() {
        history.edit("shadows", shadows(start, 100));
        assertThat(history.undoable()).contains("shadows");
        history.undo();
        assertThat(history.present()).isEqualTo(start);
        assertThat(history.undoable()).isEmpty();
        assertThat(history.redoable()).contains("shadows");
        history.redo();
        assertThat(history.present()).isEqualTo(shadows(start, 100));
        assertThat(history.redoable()).isEmpty();
    }

    @Test
    void oneGestureIsOneStep() {
        for (int samples = 10; samples < 50; samples++) {
            history.edit("shadows", shadows(history.present(), samples));
        }
        history.undo();
        assertThat(history.present()).isEqualTo(start);
    }

    @Test
    void aGestureEndsWhereItIsSaidToOrAnotherBegins() {
        history.edit("shadows", shadows(history.present(), 10));
        history.endGesture();
        history.edit("shadows", shadows(history.present(), 20));
        history.edit("bounces", bounces(history.present(), 4));
        history.edit("shadows", shadows(history.present(), 30));
        List<Integer> samples = new ArrayList<>();
        while (history.undoable().isPresent()) {
            history.undo();
            samples.add(history.present().rendering().shadowSamples());
        }
        assertThat(samples).containsExactly(20, 20, 10, 8);
    }

    @Test
    void anEditAfterUndoForgetsWhatWasTakenBack() {
        history.edit("shadows", shadows(start, 10));
        history.undo();
        history.edit("bounces", bounces(start, 5));
        assertThat(history.redoable()).isEmpty();
        history.undo();
        assertThat(history.present()).isEqualTo(start);
    }

    @Test
    void whatChangesNothingIsNoEdit() {
        history.edit("shadows", shadows(start, start.rendering().shadowSamples()));
        assertThat(history.undoable()).isEmpty();
        assertThat(history.hasChanged()).isFalse();
    }

    @Test
    void nothingToTakeBackOrMakeAgainDoesNothing() {
        history.undo();
        history.redo();
        assertThat(history.present()).isSameAs(start);
    }

    @Test
    void theViewerStays() {
        Camera elsewhere = Camera.of(new Vector3(7, 7, 7), 30, 10, 90);
        history.edit("shadows", shadows(start, 10));
        history.carryOn(history.present().withCamera(elsewhere));
        history.undo();
        assertThat(history.present()).isEqualTo(start.withCamera(elsewhere));
        history.redo();
        assertThat(history.present()).isEqualTo(shadows(start, 10).withCamera(elsewhere));
    }

    private static Scene placed(Scene scene, int index, double x) {
        List<Sphere> spheres = new ArrayList<>(scene.spheres());
        Sphere old = spheres.get(index);
        Vector3 place = new Vector3(x, old.position().y(), old.position().z());
        spheres.set(index, old.withPosition(place));
        return scene.withSpheres(spheres);
    }

    private double x(int index) {
        return history.present().spheres().get(index).position().x();
    }

    @Test
    void spheresThatTimeHasMovedAreNotPutBackByEditsOfOthers() {
        double firstX = x(0);
        history.edit("first", placed(start, 0, 11));
        history.markSaved(history.version());
        history.carryOnMoved(placed(history.present(), 1, 21));
        history.edit("second", placed(history.present(), 1, 22));
        history.undo();
        assertThat(x(1)).isEqualTo(21);
        assertThat(history.hasChanged()).isTrue();
        history.undo();
        assertThat(x(0)).isEqualTo(firstX);
        assertThat(x(1)).isEqualTo(21);
        assertThat(history.hasChanged()).isTrue();
        history.redo();
        assertThat(x(0)).isEqualTo(11);
        assertThat(x(1)).isEqualTo(21);
        assertThat(history.hasChanged()).isTrue();
        history.redo();
        assertThat(x(1)).isEqualTo(22);
    }

    @Test
    void aSphereThatComesBackLeavesTheOthersWhereTimeHasMovedThem() {
        history.edit(
                "delete",
                start.withSpheres(start.spheres().subList(1, start.spheres().size())));
        history.carryOnMoved(placed(history.present(), 0, 21));
        history.edit("shadows", shadows(history.present(), 10));
        history.undo();
        history.undo();
        assertThat(history.present().spheres()).isEqualTo(placed(start, 1, 21).spheres());
        history.redo();
        assertThat(x(0)).isEqualTo(21);
    }

    @Test
    void knowsWhetherThereIsSomethingToSave() {
        assertThat(history.hasChanged()).isFalse();
        history.edit("shadows", shadows(start, 10));
        assertThat(history.hasChanged()).isTrue();
        assertThat(history.markSaved(history.version())).isTrue();
        assertThat(history.hasChanged()).isFalse();
        history.undo();
        assertThat(history.hasChanged()).isTrue();
        history.redo();
        assertThat(history.hasChanged()).isFalse();
        history.carryOn(history.present().withCamera(Camera.of(new Vector3(1, 1, 1), 0, 0, 60)));
        assertThat(history.hasChanged()).isFalse();
        history.edit("shadows", shadows(history.present(), 11));
        assertThat(history.hasChanged()).isTrue();
    }

    @Test
    void whatIsEditedWhileItIsWrittenIsStillToBeSaved() {
        history.edit("shadows", shadows(start, 10));
        SceneHistory.Version written = history.version();
        history.edit("shadows", shadows(start, 11));
        assertThat(history.markSaved(written)).isTrue();
        assertThat(history.hasChanged()).isTrue();
        assertThat(written.scene()).isEqualTo(shadows(start, 10));
        assertThat(new SceneHistory(start).markSaved(written)).isFalse();
    }

    @Test
    void anotherEditIsNotTakenForTheSavedOne() {
        history.edit("shadows", shadows(start, 10));
        assertThat(history.markSaved(history.version())).isTrue();
        history.undo();
        history.edit("shadows", shadows(start, 12));
        assertThat(history.hasChanged()).isTrue();
    }

    @Test
    void stepsAreLimited() {
        for (int i = 0; i < SceneHistory.MAX_STEPS + 50; i++) {
            history.edit("shadows", shadows(history.present(), 100 + i % 2));
            history.endGesture();
        }
        int steps = 0;
        while (history.undoable().isPresent()) {
            history.undo();
            steps++;
        }
        assertThat(steps).isEqualTo(SceneHistory.MAX_STEPS);
    }

    @Test
    void spheresThatAreHeldAreLimited() {
        Sphere sphere = start.spheres().getFirst();
        for (int i = 0; i < 15; i++) {
            history.edit("sphere " + i, start.withSpheres(Collections.nCopies(500_000 + i, sphere)));
        }
        int steps = 0;
        while (history.undoable().isPresent()) {
            history.undo();
            steps++;
        }
        assertThat(steps).isEqualTo(7);
    }

    @Property(seed = "20261121", tries = 200)
    void undoingAllAndRedoingAllComesBack(@ForAll @Size(max = 30) List<@IntRange(min = 1, max = 5) Integer> samples) {
        SceneHistory any = new SceneHistory(start);
        for (int count : samples) {
            any.edit("shadows", shadows(any.present(), count));
            if (count % 2 == 0) {
                any.endGesture();
            }
        }
        Scene end = any.present();
        while (any.undoable().isPresent()) {
            any.undo();
        }
        assertThat(any.present()).isEqualTo(start);
        assertThat(any.hasChanged()).isFalse();
        while (any.redoable().isPresent()) {
            any.redo();
        }
        assertThat(any.present()).isEqualTo(end);
    }

    @Test
    void theFieldOfViewIsTakenBackAndIsNothingToSave() {
        Scene scene = start;
        SceneHistory history = new SceneHistory(scene);
        history.edit("field of view", scene.withCamera(scene.camera().withFieldOfViewDegrees(33)));
        Camera walked = history.present().camera().withYawDegrees(12);
        history.carryOn(history.present().withCamera(walked));
        assertThat(history.hasChanged()).isFalse();

        history.undo();
        assertThat(history.present().camera())
                .isEqualTo(walked.withFieldOfViewDegrees(scene.camera().fieldOfViewDegrees()));
        history.redo();
        assertThat(history.present().camera()).isEqualTo(walked);
    }

    @Test
    void theLensIsTakenBackAndIsToBeSaved() {
        SceneHistory history = new SceneHistory(start);
        history.edit("aperture", start.withCamera(start.camera().withAperture(0.1)));
        assertThat(history.hasChanged()).isTrue();
        history.edit(
                "focus distance",
                history.present().withCamera(history.present().camera().withFocusDistance(3)));
        Camera walked = history.present().camera().withYawDegrees(12);
        history.carryOn(history.present().withCamera(walked));

        history.undo();
        assertThat(history.present().camera())
                .isEqualTo(walked.withFocusDistance(start.camera().focusDistance()));
        history.undo();
        assertThat(history.present().camera()).isEqualTo(start.camera().withYawDegrees(12));
        assertThat(history.hasChanged()).isFalse();
        history.redo();
        history.redo();
        assertThat(history.present().camera()).isEqualTo(walked);
    }
}
