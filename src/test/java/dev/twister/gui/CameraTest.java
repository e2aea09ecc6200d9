package dev.twister.gui;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import dev.twister.gui.camera.CameraKeys;
import dev.twister.gui.drawing.DrawnPicture;
import dev.twister.gui.picture.PictureView;
import dev.twister.scene.Camera;
import dev.twister.world.animation.CameraMotion;
import javafx.beans.property.SimpleBooleanProperty;
import javafx.event.Event;
import javafx.geometry.Bounds;
import javafx.scene.Cursor;
import javafx.scene.Node;
import javafx.scene.Scene;
import javafx.scene.input.KeyCode;
import javafx.scene.input.KeyEvent;
import javafx.scene.input.MouseButton;
import javafx.scene.layout.Pane;
import org.junit.jupiter.api.Test;

/** The camera in the hands of a person. */
class CameraTest {
    @Test
    void keysMoveForAsLongAsTheyAreHeld() {
        try (WindowDriver driver = WindowDriver.open()) {
            Camera start = camera(driver);

            driver.press(KeyCode.W, KeyCode.SHIFT);
            driver.await(() -> driver.studio.scene().camera().position().z()
                    > start.position().z() + 1);
            driver.release(KeyCode.W, KeyCode.SHIFT);
            Camera there = camera(driver);
            driver.pulse();
            driver.pulse();

            assertThat(camera(driver)).isEqualTo(there);
            DrawnPicture picture = driver.awaitCurrentPicture();
            assertThat(picture.request().scene().camera()).isEqualTo(there);
        }
    }

    @Test
    void arrowsLookAroundAndLeaveTheFocusOnThePicture() {
        try (WindowDriver driver = WindowDriver.openWithPanel()) {
            Camera start = camera(driver);

            driver.press(KeyCode.RIGHT, KeyCode.DOWN);
            driver.await(() -> driver.studio.scene().camera().yawDegrees() > start.yawDegrees() + 2);
            driver.release(KeyCode.RIGHT, KeyCode.DOWN);
            driver.pulse();

            assertThat(camera(driver).pitchDegrees()).isGreaterThan(start.pitchDegrees());
            assertThat(camera(driver).position()).isEqualTo(start.position());
            Node focused = WindowDriver.call(() -> driver.stage.getScene().getFocusOwner());
            assertThat(focused).isInstanceOf(PictureView.class);

            Camera there = camera(driver);
            Node control = driver.find("#reset-everything", Node.class);
            driver.run(control::requestFocus);
            driver.type(KeyCode.UP);
            driver.pulse();
            assertThat(camera(driver)).isEqualTo(there);
        }
    }

    @Test
    void theCameraStopsAboveThePlane() {
        try (WindowDriver driver = WindowDriver.open()) {
            double lowest = driver.studio.scene().ground().height() + CameraMotion.CLEARANCE_METERS;

            driver.press(KeyCode.Q, KeyCode.SHIFT);
            driver.await(() -> driver.studio.scene().camera().position().y() == lowest);
            driver.pulse();
            driver.release(KeyCode.Q, KeyCode.SHIFT);

            assertThat(camera(driver).position().y()).isEqualTo(lowest);
        }
    }

    @Test
    void homeAndKeptViewsBringTheCameraBack() {
        try (WindowDriver driver = WindowDriver.open()) {
            Camera home = camera(driver);
            driver.press(KeyCode.D);
            driver.await(() -> !driver.studio.scene().camera().equals(home));
            driver.release(KeyCode.D);
            Camera aside = camera(driver);

            driver.press(KeyCode.CONTROL);
            driver.type(KeyCode.DIGIT1);
            driver.release(KeyCode.CONTROL);
            driver.type(KeyCode.HOME);
            assertThat(camera(driver)).isEqualTo(home);

            driver.type(KeyCode.DIGIT1);
            assertThat(camera(driver)).isEqualTo(aside);
            driver.type(KeyCode.DIGIT4);
            assertThat(camera(driver)).isEqualTo(aside);
        }
    }

    @Test
    void draggingLooksWithThePointerHidden() {
        try (WindowDriver driver = WindowDriver.open()) {
            Camera start = camera(driver);
            Bounds area = driver.pictureOnScreen();
            double x = area.getCenterX();
            double y = area.getCenterY();

            driver.withRobot(robot -> robot.mouseMove(x, y));
            driver.withRobot(robot -> robot.mousePress(MouseButton.PRIMARY));
            driver.withRobot(robot -> robot.mouseMove(x + 30, y + 12));

            assertThat(cursor(driver)).isEqualTo(Cursor.NONE);
            driver.withRobot(robot -> robot.mouseRelease(MouseButton.PRIMARY));
            assertThat(cursor(driver)).isEqualTo(Cursor.DEFAULT);
            double degrees = start.fieldOfViewDegrees() / Math.min(area.getWidth(), area.getHeight());
            assertThat(camera(driver).yawDegrees()).isCloseTo(start.yawDegrees() + 30 * degrees, within(1e-6));
            assertThat(camera(driver).pitchDegrees()).isCloseTo(start.pitchDegrees() + 12 * degrees, within(1e-6));

            driver.withRobot(robot -> robot.mouseMove(x, y));
            assertThat(camera(driver).yawDegrees()).isCloseTo(start.yawDegrees() + 30 * degrees, within(1e-6));
        }
    }

    @Test
    void aViewIsKeptWithAWordAndOneThatIsNotThereIsSaid() {
        try (WindowDriver driver = WindowDriver.open()) {
            driver.typeWith(KeyCode.DIGIT1, KeyCode.CONTROL);
            assertThat(driver.notice()).isEqualTo("View kept under 1: View 1");
            driver.type(KeyCode.DIGIT5);
            assertThat(driver.notice()).isEqualTo("No view is kept under 5; Ctrl+5 keeps this one");
        }
    }

    @Test
    void theWheelChangesTheFieldOfView() {
        try (WindowDriver driver = WindowDriver.open()) {
            Camera start = camera(driver);
            Bounds area = driver.pictureOnScreen();

            driver.withRobot(robot -> robot.mouseMove(area.getCenterX(), area.getCenterY()));
            driver.withRobot(robot -> robot.mouseWheel(-2));

            assertThat(camera(driver).fieldOfViewDegrees()).isLessThan(start.fieldOfViewDegrees());
            driver.withRobot(robot -> robot.mouseWheel(2));
            assertThat(camera(driver).fieldOfViewDegrees()).isCloseTo(start.fieldOfViewDegrees(), within(1e-9));
        }
    }

    @Test
    void keysAreLetGoWhenTheWindowLosesTheFocus() {
        try (WindowDriver driver = WindowDriver.open()) {
            SimpleBooleanProperty focused = new SimpleBooleanProperty(true);
            Scene keyboard = WindowDriver.call(() -> new Scene(new Pane()));
            driver.run(() -> CameraKeys.install(keyboard, driver.studio).releaseWithout(focused));
            driver.run(() -> Event.fireEvent(
                    keyboard, new KeyEvent(KeyEvent.KEY_PRESSED, "w", "w", KeyCode.W, false, false, false, false)));
            driver.pulse();
            driver.pulse();

            Camera there = WindowDriver.call(() -> {
                focused.set(false);
                return driver.studio.scene().camera();
            });
            driver.pulse();
            driver.pulse();

            assertThat(there.position())
                    .isNotEqualTo(driver.studio.document().original().camera().position());
            assertThat(camera(driver)).isEqualTo(there);
        }
    }

    private static Camera camera(WindowDriver driver) {
        return WindowDriver.call(() -> driver.studio.scene().camera());
    }

    private static Cursor cursor(WindowDriver driver) {
        return WindowDriver.call(
                () -> driver.stage.getScene().getRoot().lookup(".picture").getCursor());
    }
}
