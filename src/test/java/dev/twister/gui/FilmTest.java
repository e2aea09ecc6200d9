package dev.twister.gui;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import dev.twister.gui.camera.FilmBar;
import dev.twister.gui.camera.KeyframeMarks;
import dev.twister.gui.controls.Command;
import dev.twister.gui.edit.BodyNumber;
import dev.twister.gui.edit.TrackEdits;
import dev.twister.gui.picture.PictureView;
import dev.twister.gui.studio.OpenedScene;
import dev.twister.scene.Camera;
import dev.twister.scene.CameraKeyframe;
import dev.twister.scene.Scene;
import dev.twister.scene.Track;
import dev.twister.scene.Vector3;
import dev.twister.scene.format.SceneReader;
import dev.twister.scene.format.SceneWriter;
import dev.twister.world.animation.CameraPath;
import java.nio.file.Path;
import java.util.List;
import javafx.geometry.Bounds;
import javafx.scene.control.Button;
import javafx.scene.control.ComboBox;
import javafx.scene.control.Slider;
import javafx.scene.control.TextField;
import javafx.scene.input.KeyCode;
import javafx.scene.input.MouseButton;
import javafx.scene.layout.Pane;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Keyframes set, listed, moved, deleted and played by hand. */
class FilmTest {
    private static WindowDriver driver;

    @TempDir
    private Path folder;

    @BeforeAll
    static void open() {
        driver = WindowDriver.openWithPanel();
    }

    @AfterAll
    static void close() {
        driver.close();
    }

    @BeforeEach
    void startAnew() {
        show(WindowScenes.tiny());
    }

    private static void show(Scene scene) {
        driver.run(() -> driver.studio.show(new OpenedScene(Path.of("test.json"), scene)));
        driver.awaitCurrentPicture();
        focusPicture();
    }

    private static void focusPicture() {
        PictureView view = driver.find(".picture", PictureView.class);
        driver.run(view::requestFocus);
    }

    private static Camera camera() {
        return WindowDriver.call(driver.studio::scene).camera();
    }

    private static List<Double> times() {
        return camera().keyframes().stream().map(CameraKeyframe::seconds).toList();
    }

    private static double seconds() {
        return WindowDriver.call(driver.studio.film().secondsProperty()::get);
    }

    private static boolean playing() {
        return WindowDriver.call(driver.studio.film().playingProperty()::get);
    }

    private static void walkTo(double x) {
        driver.run(() -> driver.studio.moveCamera(camera -> camera.withPosition(new Vector3(x, 2, -8))));
    }

    private static void goTo(double time) {
        TextField field = driver.find("#film-time", TextField.class);
        driver.run(field::requestFocus);
        driver.typeWith(KeyCode.A, KeyCode.CONTROL);
        driver.run(() -> field.replaceSelection(String.valueOf(time)));
        driver.type(KeyCode.ENTER);
    }

    /** At 1 s at x = 0, at 3 s at x = 4. */
    private static void setTwo() {
        driver.type(Command.FILM.keys());
        goTo(1);
        walkTo(0);
        driver.type(Command.SET_KEYFRAME.keys());
        goTo(3);
        walkTo(4);
        driver.type(Command.SET_KEYFRAME.keys());
    }

    private static FilmBar bar() {
        return driver.find("#film", FilmBar.class);
    }

    @Test
    void keyframesAreSetFromTheCameraAtATimeAndTakenBack() {
        assertThat(WindowDriver.call(bar()::isVisible)).isFalse();
        setTwo();
        assertThat(WindowDriver.call(bar()::isVisible)).isTrue();
        assertThat(times()).containsExactly(1.0, 3.0);
        assertThat(camera().keyframes().getLast().position()).isEqualTo(new Vector3(4, 2, -8));
        assertThat(driver.notice()).startsWith("Keyframe set at 3 s");
        assertThat(WindowDriver.call(driver.studio.document().editsProperty()::get)
                        .changed())
                .isTrue();
        assertThat(WindowDriver.call(driver.studio.document().editsProperty()::get)
                        .undoable())
                .contains("set keyframe");
        driver.type(Command.UNDO.keys());
        assertThat(times()).containsExactly(1.0);
        // Undo leaves the camera where it is.
        assertThat(camera().position().x()).isEqualTo(4);
        driver.type(Command.REDO.keys());
        assertThat(times()).containsExactly(1.0, 3.0);
        Path file = folder.resolve("film.json");
        SceneWriter.write(WindowDriver.call(driver.studio::scene), file);
        assertThat(SceneReader.read(file).camera().keyframes()).isEqualTo(camera().keyframes());
    }

    private static <T> List<String> labels(ComboBox<T> list) {
        return list.getItems().stream().map(list.getConverter()::toString).toList();
    }

    @Tag("slow")
    @Test
    void theListAndTheKeysGoToAKeyframe() {
        setTwo();
        ComboBox<?> list = driver.find("#film-list", ComboBox.class);
        assertThat(WindowDriver.call(() -> labels(list))).containsExactly("2 keyframes", "1 of 2: 1 s", "2 of 2: 3 s");
        driver.run(() -> list.getSelectionModel().select(1));
        assertThat(seconds()).isEqualTo(1);
        assertThat(camera().position().x()).isZero();
        driver.type(Command.NEXT_KEYFRAME.keys());
        assertThat(seconds()).isEqualTo(3);
        assertThat(camera().position().x()).isEqualTo(4);
        assertThat(WindowDriver.call(
                        () -> labels(list).get(list.getSelectionModel().getSelectedIndex())))
                .isEqualTo("2 of 2: 3 s");
        driver.type(Command.NEXT_KEYFRAME.keys());
        assertThat(driver.notice()).isEqualTo("No later keyframe");
        driver.type(Command.PREVIOUS_KEYFRAME.keys());
        assertThat(camera().position().x()).isZero();
    }

    @Test
    void aTimeBetweenShowsThePathAndATimeAfterItLeavesTheCamera() {
        setTwo();
        Slider slider = driver.find("#film-slider", Slider.class);
        driver.run(() -> slider.setValue(2));
        assertThat(camera()).isEqualTo(CameraPath.at(camera(), 2));
        assertThat(camera().position().x()).isCloseTo(2, within(1e-9));
        walkTo(-7);
        driver.run(() -> slider.setValue(8));
        assertThat(camera().position().x()).isEqualTo(-7);
        assertThat(WindowDriver.call(driver.studio.document().editsProperty()::get)
                        .undoable())
                .contains("set keyframe");
    }

    @Tag("slow")
    @Test
    void aKeyframeIsDeletedAtItsTime() {
        setTwo();
        Button delete = driver.find("#film-delete-keyframe", Button.class);
        goTo(2);
        assertThat(WindowDriver.call(delete::isDisabled)).isTrue();
        driver.type(Command.DELETE_KEYFRAME.keys());
        assertThat(driver.notice()).isEqualTo("No keyframe at 2 s");
        goTo(1);
        driver.run(delete::fire);
        assertThat(times()).containsExactly(3.0);
        assertThat(WindowDriver.call(driver.studio.document().editsProperty()::get)
                        .undoable())
                .contains("delete keyframe");
    }

    @Test
    void aMarkIsDraggedToAnotherTimeAndThatIsOneEdit() {
        setTwo();
        driver.pulse();
        KeyframeMarks marks = driver.find("#film-marks", KeyframeMarks.class);
        var place = WindowDriver.call(() -> {
            var mark = marks.getChildrenUnmodifiable().getLast();
            return mark.localToScreen(mark.getBoundsInLocal());
        });
        driver.withRobot(hand -> hand.mouseMove(place.getCenterX(), place.getCenterY()));
        driver.withRobot(hand -> hand.mousePress(MouseButton.PRIMARY));
        driver.withRobot(hand -> hand.mouseMove(place.getCenterX() + 10, place.getCenterY()));
        driver.withRobot(hand -> hand.mouseMove(place.getCenterX() + 20, place.getCenterY()));
        driver.withRobot(hand -> hand.mouseRelease(MouseButton.PRIMARY));
        assertThat(times().getLast()).isGreaterThan(3.2);
        assertThat(seconds()).isEqualTo(times().getLast());
        driver.run(driver.studio::undo);
        assertThat(times()).containsExactly(1.0, 3.0);
    }

    @Tag("slow")
    @Test
    void theFilmPlaysFromItsBeginningToItsEnd() {
        driver.type(Command.PLAY.keys());
        assertThat(driver.notice()).isEqualTo("Set two keyframes or more to play them");
        setTwo();
        driver.type(Command.PLAY.keys());
        driver.await(() -> seconds() > 1);
        driver.await(() -> !playing());
        assertThat(seconds()).isEqualTo(3);
        assertThat(camera().position()).isEqualTo(new Vector3(4, 2, -8));
        goTo(1);
        focusPicture();
        driver.type(Command.PLAY.keys());
        driver.await(() -> seconds() > 1 && seconds() < 3);
        driver.type(Command.PLAY.keys());
        assertThat(playing()).isFalse();
        assertThat(WindowDriver.call(driver.studio.document().editsProperty()::get)
                        .undoable())
                .contains("set keyframe");
    }

    @Tag("slow")
    @Test
    void anotherSceneHasItsOwnKeyframesAndAViewLeavesThem() {
        setTwo();
        driver.run(() -> driver.studio.cameraControl().keepView(1));
        Scene film = WindowDriver.call(driver.studio::scene);
        show(WindowScenes.tiny());
        assertThat(WindowDriver.call(bar()::isVisible)).isFalse();
        assertThat(seconds()).isZero();
        show(film);
        driver.run(() -> {
            driver.studio.moveCamera(camera -> camera.withYawDegrees(90));
            driver.studio.cameraControl().recallView(1);
        });
        assertThat(camera()).isEqualTo(film.camera());
        assertThat(camera().keyframes()).hasSize(2);
        assertThat(WindowDriver.call(bar()::isVisible)).isTrue();
    }

    @Tag("slow")
    @Test
    void aKeyframeOfABodyIsSetByItsMenuAndDraggedInItsRow() {
        driver.run(() -> driver.studio.selection().select(BodyNumber.ofSphere(0)));
        driver.type(Command.SET_KEYFRAME_OF.keys());
        driver.type(KeyCode.ENTER);
        assertThat(WindowDriver.call(() -> driver.studio.scene().tracks()))
                .extracting(Track::property)
                .containsExactly("position", "radius");
        driver.pulse();
        Pane lane = driver.find("#lane-spheres-0", Pane.class);
        Slider slider = driver.find("#film-slider", Slider.class);
        driver.pulse();
        Bounds line = WindowDriver.call(() -> slider.localToScreen(slider.getLayoutBounds()));
        Bounds row = WindowDriver.call(() -> lane.localToScreen(lane.getLayoutBounds()));
        assertThat(row.getMinX()).isCloseTo(line.getMinX(), within(1.0));
        assertThat(row.getMaxX()).isCloseTo(line.getMaxX(), within(1.0));
        var place = WindowDriver.call(() -> lane.localToScreen(lane.getBoundsInLocal()));
        double y = place.getCenterY();
        driver.withRobot(hand -> hand.mouseMove(place.getMinX() + 8, y));
        driver.withRobot(hand -> hand.mousePress(MouseButton.PRIMARY));
        driver.withRobot(hand -> hand.mouseMove(place.getMinX() + 30, y));
        driver.withRobot(hand -> hand.mouseMove(place.getCenterX(), y));
        driver.withRobot(hand -> hand.mouseRelease(MouseButton.PRIMARY));

        assertThat(WindowDriver.call(() -> TrackEdits.times(driver.studio.scene())))
                .singleElement()
                .satisfies(time -> assertThat(time).isCloseTo(5, within(0.5)));
        driver.run(driver.studio::undo);
        assertThat(WindowDriver.call(() -> TrackEdits.times(driver.studio.scene())))
                .containsExactly(0.0);
    }
}
