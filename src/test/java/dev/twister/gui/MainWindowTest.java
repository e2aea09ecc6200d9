package dev.twister.gui;

import static org.assertj.core.api.Assertions.assertThat;

import dev.twister.gui.drawing.DrawnPicture;
import javafx.geometry.Bounds;
import javafx.scene.control.Label;
import javafx.scene.paint.Color;
import org.junit.jupiter.api.Test;

class MainWindowTest {
    private static final double ROUNDING = 1.5 / 255;

    @Test
    void theScreenShowsTheEnginesPixels() {
        try (WindowDriver driver = WindowDriver.open()) {
            DrawnPicture picture = driver.awaitRest();
            Bounds area = WindowDriver.call(() -> driver.stage
                    .getScene()
                    .getRoot()
                    .lookup(".picture")
                    .localToScreen(
                            driver.stage.getScene().getRoot().lookup(".picture").getLayoutBounds()));

            for (int[] place : new int[][] {{10, 150}, {100, 180}, {200, 150}, {160, 130}}) {
                int argb = picture.frame().argb()[place[1] * picture.frame().width() + place[0]];
                Color seen = driver.pixel(area.getMinX() + place[0], area.getMinY() + place[1]);

                assertThat(Math.abs(seen.getRed() - (argb >> 16 & 0xFF) / 255.0))
                        .isLessThan(ROUNDING);
                assertThat(Math.abs(seen.getGreen() - (argb >> 8 & 0xFF) / 255.0))
                        .isLessThan(ROUNDING);
                assertThat(Math.abs(seen.getBlue() - (argb & 0xFF) / 255.0)).isLessThan(ROUNDING);
            }
        }
    }

    @Test
    void aMessageThatIsCutOffIsWholeInItsTooltip() {
        String sentence = "/skies/huge.hdr: 2000000000 x 2000000000 texels, 1 x 1 to 16384 x 8192 are allowed";
        try (WindowDriver driver = WindowDriver.open()) {
            driver.run(() -> driver.studio.notice(sentence));
            driver.pulse();
            Label notice = driver.find("#notice", Label.class);
            assertThat(WindowDriver.call(notice::isTextTruncated)).isTrue();
            assertThat(WindowDriver.call(() -> notice.getTooltip().getText()).replace('\n', ' '))
                    .isEqualTo(sentence);
        }
    }
}
