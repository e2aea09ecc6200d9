package dev.twister.gui;

import static org.assertj.core.api.Assertions.assertThat;

import dev.twister.scene.Camera;
import javafx.geometry.Bounds;
import javafx.scene.Node;
import javafx.scene.control.TableView;
import javafx.scene.input.KeyCode;
import org.junit.jupiter.api.Test;

/** The path of a pixel in the window. */
class PixelPathTest {
    @Test
    void aKeyShowsThePathUnderThePointerUntilEscape() {
        try (WindowDriver driver = WindowDriver.open()) {
            Bounds view = driver.pictureOnScreen();
            driver.withRobot(hand -> hand.mouseMove(view.getCenterX(), view.getCenterY()));
            driver.typeWith(KeyCode.P, KeyCode.CONTROL);

            assertThat(driver.find("#path", Node.class).isVisible()).isTrue();
            assertThat(driver.find("#path-steps", TableView.class).getItems().size())
                    .isPositive();
            assertThat(driver.text("path-heading"))
                    .contains("x " + (int) (view.getWidth() / 2) + ", y " + (int) (view.getHeight() / 2));

            Camera before = driver.studio.scene().camera();
            driver.press(KeyCode.D);
            driver.await(() -> !driver.studio.scene().camera().equals(before));
            driver.release(KeyCode.D);
            driver.awaitCurrentPicture();
            assertThat(driver.find("#path", Node.class).isVisible()).isTrue();

            driver.type(KeyCode.ESCAPE);
            assertThat(driver.find("#path", Node.class).isVisible()).isFalse();
        }
    }
}
