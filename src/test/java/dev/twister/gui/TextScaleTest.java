package dev.twister.gui;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.stream.Stream;
import javafx.scene.Node;
import javafx.scene.control.Label;
import javafx.scene.control.Labeled;
import javafx.scene.input.KeyCode;
import javafx.scene.layout.Region;
import javafx.scene.text.Font;
import javafx.stage.Screen;
import javafx.stage.Window;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

class TextScaleTest {
    @Test
    void whatIsPrintedIsAFactor() {
        assertThat(TextScale.parse("1.5\n")).contains(1.5);
        assertThat(TextScale.parse("")).isEmpty();
        assertThat(TextScale.parse("No such schema")).isEmpty();
        assertThat(TextScale.parse("0")).isEmpty();
        assertThat(TextScale.parse("1e9")).isEmpty();
        assertThat(TextScale.parse("NaN")).isEmpty();
    }

    @Test
    void allGrowsWithTheText() {
        double usual;
        try (WindowDriver driver = WindowDriver.openWithPanel()) {
            usual = width(driver);
        }
        try (WindowDriver driver = WindowDriver.openWithPanel(1.5)) {
            assertThat(WindowDriver.call(
                            () -> driver.find("#facts", Label.class).getFont().getSize()))
                    .isCloseTo(1.5 * Font.getDefault().getSize(), within(0.01));
            assertThat(width(driver)).isCloseTo(1.5 * usual, within(2.0));
        }
    }

    @Tag("slow")
    @Test
    void nothingIsCutOffWhereTextIsTwiceAsLarge() {
        try (WindowDriver driver = WindowDriver.openWithPanel(2)) {
            driver.pulse();
            List<Labeled> cut = WindowDriver.call(() -> Stream.of("#panel", ".frame-times", ".menu-bar")
                    .flatMap(area -> driver.stage.getScene().lookup(area).lookupAll("*").stream())
                    .filter(TextScaleTest::isSeen)
                    .filter(node -> node instanceof Labeled text && text.isTextTruncated())
                    .map(Labeled.class::cast)
                    .toList());
            assertThat(cut).isEmpty();
        }
    }

    @Tag("slow")
    @Test
    void theListOfKeysFitsTheScreen() {
        try (WindowDriver driver = WindowDriver.openWithPanel(2)) {
            driver.type(KeyCode.F1);
            Window help = WindowDriver.call(() -> Window.getWindows().stream()
                    .filter(window -> !window.equals(driver.stage))
                    .findFirst()
                    .orElseThrow());
            driver.pulse();
            assertThat(WindowDriver.call(help::getHeight))
                    .isLessThanOrEqualTo(Screen.getPrimary().getVisualBounds().getHeight());
        }
    }

    /** Sections for what is not selected are not laid out. */
    private static boolean isSeen(Node node) {
        return node == null || (node.isVisible() && isSeen(node.getParent()));
    }

    private static double width(WindowDriver driver) {
        return WindowDriver.call(() -> driver.find("#panel", Region.class).getWidth());
    }
}
