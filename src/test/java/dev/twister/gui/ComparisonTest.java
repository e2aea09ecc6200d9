package dev.twister.gui;

import static org.assertj.core.api.Assertions.assertThat;

import dev.twister.gui.picture.Comparison;
import dev.twister.gui.picture.Comparison.Mode;
import dev.twister.gui.picture.PictureDifference;
import dev.twister.world.StageOrView;
import java.util.Optional;
import javafx.geometry.Bounds;
import javafx.scene.Node;
import javafx.scene.input.KeyCode;
import org.junit.jupiter.api.Test;

/** Two pictures beside each other, and one under a magnifying glass. */
class ComparisonTest {
    @Test
    void aSecondPictureIsComparedWithTheFirst() {
        try (WindowDriver driver = WindowDriver.open()) {
            Comparison comparison = driver.window.workbench().comparison();
            driver.typeWith(KeyCode.K, KeyCode.CONTROL);
            driver.await(() -> largest(comparison).filter(error -> error == 0).isPresent());
            assertThat(driver.text("difference")).isEqualTo("No difference");

            driver.run(() -> comparison.shownProperty().set(Optional.of(StageOrView.NORMAL)));
            driver.await(() -> largest(comparison).filter(error -> error > 100).isPresent());

            assertThat(driver.text("difference"))
                    .startsWith("Largest difference: ")
                    .contains(" of 255 at x ");
            assertThat(driver.text("split-right")).contains("Normal");
            driver.typeWith(KeyCode.K, KeyCode.CONTROL);
            assertThat(comparison.modeProperty().get()).isEqualTo(Mode.OFF);
        }
    }

    @Test
    void theInspectorReadsThePixelUnderThePointerOfAMagnifiedPicture() {
        try (WindowDriver driver = WindowDriver.open()) {
            driver.awaitRest();
            driver.typeWith(KeyCode.I, KeyCode.CONTROL);
            for (int step = 0; step < 20; step++) {
                driver.typeWith(KeyCode.EQUALS, KeyCode.CONTROL);
            }
            driver.pulse();
            Bounds view = driver.pictureOnScreen();
            Node image = driver.find(".picture > .image-view", Node.class);
            assertThat(image.getBoundsInParent().getWidth()).isGreaterThan(50 * view.getWidth());

            driver.withRobot(hand -> hand.mouseMove(view.getCenterX(), view.getCenterY()));

            int x = (int) (view.getWidth() / 2);
            driver.await(() -> driver.text("inspector-text").startsWith("x " + x + " "));
            assertThat(driver.text("inspector-text")).contains("radiance ").contains(" samples");
        }
    }

    private static Optional<Integer> largest(Comparison comparison) {
        return comparison.differenceProperty().get().map(PictureDifference::largest);
    }
}
