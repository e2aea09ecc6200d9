package dev.twister.gui;

import static org.assertj.core.api.Assertions.assertThat;

import dev.twister.gui.panel.PanelRow;
import dev.twister.kernel.Layout;
import dev.twister.scene.Shading;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import javafx.scene.control.Menu;
import javafx.scene.control.MenuBar;
import javafx.scene.control.MenuItem;
import javafx.scene.control.SeparatorMenuItem;
import javafx.scene.input.KeyCode;
import javafx.scene.input.KeyCodeCombination;
import javafx.scene.input.KeyCombination;
import org.junit.jupiter.api.Test;

/** The menus by their underlined letters. */
class MenuTest {
    private static final Pattern MARK = Pattern.compile("(?<!_)(?:__)*_([^_])");

    @Test
    void everyItemHasALetterOfItsOwnInItsMenu() {
        try (WindowDriver driver = WindowDriver.open()) {
            List<List<String>> menus = new ArrayList<>();
            collect(WindowDriver.call(() -> bar(driver).getMenus()), menus);

            assertThat(menus).hasSizeGreaterThan(6);
            for (List<String> menu : menus) {
                List<String> letters = menu.stream()
                        .map(text -> letter(text).orElse("none in " + text))
                        .toList();
                assertThat(letters).doesNotHaveDuplicates().allMatch(letter -> letter.length() == 1);
            }
        }
    }

    /** A row's key would keep the menu from its own. */
    @Test
    void noRowOfThePanelHasTheKeyOfAMenu() {
        try (WindowDriver driver = WindowDriver.open()) {
            driver.run(() -> driver.studio.selection().select(Layout.FIRST_SPHERE));
            List<KeyCombination> rows = WindowDriver.call(() -> driver.window.workbench().panel().rows().stream()
                    .map(PanelRow::keys)
                    .toList());
            for (Menu menu : WindowDriver.call(() -> bar(driver).getMenus())) {
                KeyCode code =
                        KeyCode.valueOf(letter(menu.getText()).orElseThrow().toUpperCase(Locale.ROOT));
                assertThat(rows)
                        .as(menu.getText())
                        .doesNotContain(new KeyCodeCombination(code, KeyCombination.ALT_DOWN));
            }
        }
    }

    @Test
    void aFilesNameKeepsItsUnderscores() {
        try (WindowDriver driver = WindowDriver.open()) {
            driver.run(() -> driver.window.workbench().settings().remember(Path.of("a_b.json")));
            Menu recent = (Menu) item(driver, "recent");
            MenuItem file = recent.getItems().getFirst();
            assertThat(file.getText()).endsWith("a_b.json");
            assertThat(file.isMnemonicParsing()).isFalse();
        }
    }

    @Test
    void whatCanBeUndoneLeavesTheLetter() {
        try (WindowDriver driver = WindowDriver.open()) {
            String before = WindowDriver.call(() -> item(driver, "menu-undo").getText());
            driver.run(() -> driver.studio.edit("sky_of a_scene", scene -> scene.withShading(new Shading(0.5))));
            String after = WindowDriver.call(() -> item(driver, "menu-undo").getText());

            assertThat(after).isEqualTo(before + ": sky__of a__scene");
            assertThat(letter(after)).isEqualTo(letter(before)).isPresent();
        }
    }

    private static MenuBar bar(WindowDriver driver) {
        return (MenuBar) driver.stage.getScene().lookup(".menu-bar");
    }

    private static MenuItem item(WindowDriver driver, String id) {
        return WindowDriver.call(() -> bar(driver).getMenus().stream()
                .flatMap(menu -> menu.getItems().stream())
                .filter(item -> id.equals(item.getId()))
                .findFirst()
                .orElseThrow());
    }

    private static void collect(List<? extends MenuItem> items, List<List<String>> menus) {
        menus.add(items.stream()
                .filter(item -> item.isVisible() && item.isMnemonicParsing() && !(item instanceof SeparatorMenuItem))
                .map(MenuItem::getText)
                .toList());
        items.stream()
                .filter(Menu.class::isInstance)
                .map(Menu.class::cast)
                .forEach(menu -> collect(menu.getItems(), menus));
    }

    private static Optional<String> letter(String text) {
        Matcher mark = MARK.matcher(text);
        return mark.find() ? Optional.of(mark.group(1).toLowerCase(Locale.ROOT)) : Optional.empty();
    }
}
