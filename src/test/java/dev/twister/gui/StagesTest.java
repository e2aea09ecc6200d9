package dev.twister.gui;

import static org.assertj.core.api.Assertions.assertThat;

import dev.twister.engine.Engine;
import dev.twister.engine.NumberColors;
import dev.twister.gui.drawing.DrawnPicture;
import dev.twister.image.Frame;
import dev.twister.world.StageOrView;
import javafx.scene.control.Menu;
import javafx.scene.control.MenuBar;
import javafx.scene.control.RadioMenuItem;
import javafx.scene.input.KeyCode;
import org.junit.jupiter.api.Test;

/** Stages and views of the picture, in the window. */
class StagesTest {
    @Test
    void aKeyShowsTheNextStageOrViewAndTheMenuMarksIt() {
        try (WindowDriver driver = WindowDriver.open()) {
            driver.type(KeyCode.F4);
            DrawnPicture albedo = driver.awaitCurrentPicture();
            driver.typeWith(KeyCode.F4, KeyCode.SHIFT);
            driver.typeWith(KeyCode.F4, KeyCode.SHIFT);
            DrawnPicture softShadows = driver.awaitCurrentPicture();

            assertThat(albedo.request().shown()).isEqualTo(StageOrView.ALBEDO);
            assertThat(softShadows.input().bounces()).isZero();
            assertThat(driver.text("facts")).contains("Soft shadows");
            assertThat(marked(driver)).isEqualTo("Soft shadows");
        }
    }

    @Test
    void numbersHaveTheColorsOfTheirScale() {
        try (WindowDriver driver = WindowDriver.open()) {
            driver.run(() -> driver.studio.setShown(StageOrView.BODY));
            DrawnPicture rest = driver.awaitRest();

            Frame numbers = Frame.ofRadiance(rest.frame().width(), rest.frame().height());
            try (Engine engine = BlockEngine.offer().opener().get()) {
                engine.render(rest.input(), numbers);
            }
            assertThat(rest.samples()).isEqualTo(1);
            assertThat(rest.frame().argb()).isEqualTo(NumberColors.pixels(StageOrView.BODY, numbers.radiance()));
        }
    }

    private static String marked(WindowDriver driver) {
        MenuBar bar = driver.find(".menu-bar", MenuBar.class);
        return WindowDriver.call(() -> bar.getMenus().stream()
                .flatMap(menu -> menu.getItems().stream())
                .filter(item -> "menu-show".equals(item.getId()))
                .flatMap(item -> ((Menu) item).getItems().stream())
                .filter(RadioMenuItem.class::isInstance)
                .map(RadioMenuItem.class::cast)
                .filter(RadioMenuItem::isSelected)
                .map(item -> item.getText().replace("_", ""))
                .findFirst()
                .orElse(""));
    }
}
