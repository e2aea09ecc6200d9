package dev.twister.gui;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import dev.twister.engine.EngineOffer;
import dev.twister.engine.JvmEngines;
import dev.twister.gui.controls.Command;
import dev.twister.gui.files.SettingsStore;
import dev.twister.gui.files.WindowSettings;
import dev.twister.kernel.Layout;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import javafx.scene.Node;
import javafx.scene.control.Labeled;
import javafx.scene.control.ScrollPane;
import javafx.scene.input.KeyCode;
import javafx.stage.Stage;
import javafx.stage.Window;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** What outlives the window, and the windows that explain it. */
class SettingsTest {
    @TempDir
    private Path folder;

    @Test
    void whatWasSetIsThereTheNextTime() {
        SettingsStore store = new SettingsStore(Optional.of(folder.resolve("twister")));
        try (WindowDriver driver = WindowDriver.open(store)) {
            driver.run(() -> {
                driver.stage.setWidth(700);
                driver.stage.setHeight(500);
                driver.find(".picture", Node.class).requestFocus();
            });
            driver.typeWith(KeyCode.F9, KeyCode.SHIFT);
            driver.type(KeyCode.F9);
            assertThat(driver.find(".frame-times", Node.class).isVisible()).isFalse();
            driver.type(KeyCode.F3);
            assertThat(driver.find(".frame-times", Node.class).isVisible()).isTrue();
            driver.run(() -> driver.studio.chooseEngine(sequential()));
        }
        WindowSettings kept = store.read().settings();
        assertThat(kept.get(WindowSettings.PANEL_SHOWN)).isFalse();
        assertThat(kept.get(WindowSettings.FRAME_TIMES_SHOWN)).isTrue();
        assertThat(kept.get(WindowSettings.WIDTH)).isEqualTo(700);
        assertThat(kept.get(WindowSettings.HEIGHT)).isEqualTo(500);
        assertThat(kept.get(WindowSettings.ENGINE)).isEqualTo(JvmEngines.SEQUENTIAL);
        try (WindowDriver driver = WindowDriver.open(store)) {
            assertThat(driver.stage.getWidth()).isEqualTo(700);
            assertThat(driver.window.workbench().panel().isVisible()).isFalse();
            assertThat(driver.window
                            .workbench()
                            .panelWindow()
                            .floatingProperty()
                            .get())
                    .isTrue();
            assertThat(driver.find(".frame-times", Node.class).isVisible()).isTrue();
            driver.type(KeyCode.F3);
            assertThat(driver.find(".frame-times", Node.class).isVisible()).isFalse();
        }
    }

    @Tag("slow")
    @Test
    void theHintIsSeenUntilThePictureIsUsedAndNeverAgain() {
        SettingsStore store = new SettingsStore(Optional.of(folder));
        try (WindowDriver driver = WindowDriver.open(store)) {
            assertThat(driver.find("#hint-line", Node.class).isVisible()).isTrue();
        }
        assertThat(store.read().settings().get(WindowSettings.HINT_SEEN)).isFalse();
        try (WindowDriver driver = WindowDriver.open(store)) {
            driver.type(KeyCode.SHIFT);
            assertThat(driver.find("#hint-line", Node.class).isVisible()).isTrue();
            driver.type(KeyCode.D);
            assertThat(driver.find("#hint-line", Node.class).isVisible()).isFalse();
        }
        assertThat(store.read().settings().get(WindowSettings.HINT_SEEN)).isTrue();
        try (WindowDriver driver = WindowDriver.open(store)) {
            assertThat(driver.find("#hint-line", Node.class)).isNull();
        }
    }

    @Tag("slow")
    @Test
    void theHintIsClosedByItsCrossAndByADrag() {
        for (String used : List.of("#close-hint", ".picture")) {
            try (WindowDriver driver = WindowDriver.open(new SettingsStore(Optional.empty()))) {
                driver.click(driver.find(used, Node.class));
                assertThat(driver.find("#hint-line", Node.class).isVisible())
                        .as(used)
                        .isFalse();
                assertThat(driver.window.workbench().settings().settings().get(WindowSettings.HINT_SEEN))
                        .isTrue();
            }
        }
    }

    private static EngineOffer sequential() {
        return new JvmEngines()
                .offers().stream()
                        .filter(offer -> offer.id().equals(JvmEngines.SEQUENTIAL))
                        .findFirst()
                        .orElseThrow();
    }

    @Tag("slow")
    @Test
    void twoWindowsKeepWhatEachOfThemChanged() {
        SettingsStore store = new SettingsStore(Optional.of(folder));
        try (WindowDriver later = WindowDriver.open(store)) {
            try (WindowDriver sooner = WindowDriver.open(store)) {
                sooner.run(() -> sooner.window.workbench().settings().remember(Path.of("another.json")));
            }
            later.typeWith(KeyCode.E, KeyCode.CONTROL);
        }
        WindowSettings kept = store.read().settings();
        assertThat(kept.get(WindowSettings.Q_UP)).isTrue();
        assertThat(kept.get(WindowSettings.RECENT_SCENES)).hasSize(2);
    }

    @Test
    void aSceneThatWasAskedForIsARecentOne() {
        SettingsStore store = new SettingsStore(Optional.of(folder));
        try (WindowDriver driver = WindowDriver.open(store)) {
            assertThat(driver.window.workbench().settings().settings().get(WindowSettings.RECENT_SCENES))
                    .containsExactly(Path.of("test.json").toAbsolutePath().toString());
        }
        assertThat(store.read().settings().get(WindowSettings.RECENT_SCENES)).hasSize(1);
    }

    @Test
    void damagedSettingsAreSaid() throws IOException {
        Files.writeString(folder.resolve("window.json"), "{\"width\": ");
        try (WindowDriver driver = WindowDriver.open(new SettingsStore(Optional.of(folder)))) {
            assertThat(driver.notice()).contains("could not be read");
        }
        assertThat(folder.resolve("window.damaged.json")).hasContent("{\"width\": ");
    }

    @Test
    void helpIsShownOnceAndClosedWithEscape() {
        try (WindowDriver driver = WindowDriver.open()) {
            driver.type(KeyCode.F1);
            driver.type(KeyCode.F1);
            List<String> texts = texts("controls-page");
            assertThat(texts).contains("W A S D", "F12", "Shadow samples");
            for (Command command : Command.values()) {
                assertThat(texts).contains(command.keys().getDisplayText());
            }
            assertThat(helpWindows()).hasSize(1);
            driver.type(KeyCode.ESCAPE);
            assertThat(helpWindows()).isEmpty();
            driver.run(() -> driver.stage.requestFocus());
            driver.typeWith(KeyCode.F1, KeyCode.SHIFT);
            assertThat(texts("about-page")).anyMatch(text -> text.contains("Apache License 2.0"));
            driver.type(KeyCode.ESCAPE);
            assertThat(helpWindows()).isEmpty();
        }
    }

    @Tag("slow")
    @Test
    void otherWindowsOpenOverTheMainOne() {
        try (WindowDriver driver = WindowDriver.open()) {
            driver.run(() -> {
                driver.stage.setX(300);
                driver.stage.setY(200);
            });
            driver.typeWith(KeyCode.F1, KeyCode.SHIFT);
            Window about = helpWindows().getFirst();
            assertThat(WindowDriver.call(() -> about.getX() + about.getWidth() / 2))
                    .isCloseTo(300 + WindowDriver.WIDTH / 2.0, within(1.0));
            assertThat(WindowDriver.call(about::getY)).isNotNegative();
        }
    }

    @Tag("slow")
    @Test
    void helpScrollsByTheKeyboard() {
        try (WindowDriver driver = WindowDriver.open()) {
            driver.type(KeyCode.F1);
            ScrollPane page = (ScrollPane) helpWindows().getFirst().getScene().getRoot();
            driver.run(() -> page.getScene().getWindow().setHeight(200));
            driver.pulse();
            driver.type(KeyCode.PAGE_DOWN);
            driver.await(() -> page.getVvalue() > 0);
        }
    }

    @Tag("slow")
    @Test
    void helpTellsOfTheSelectedSpheresKeysWhileOneIsSelected() {
        try (WindowDriver driver = WindowDriver.open()) {
            driver.type(KeyCode.F1);
            assertThat(texts("controls-page")).doesNotContain("Sphere radius");
            driver.type(KeyCode.ESCAPE);

            driver.run(() -> driver.studio.selection().select(Layout.FIRST_SPHERE));
            driver.run(() -> driver.stage.requestFocus());
            driver.type(KeyCode.F1);

            assertThat(texts("controls-page")).contains("Sphere radius");
        }
    }

    private static List<Window> helpWindows() {
        return WindowDriver.call(() -> Window.getWindows().stream()
                .filter(window -> window instanceof Stage stage && stage.getOwner() != null)
                .toList());
    }

    private static List<String> texts(String page) {
        return WindowDriver.call(() -> Window.getWindows().stream()
                .map(window -> window.getScene().getRoot().lookup("#" + page))
                .filter(Objects::nonNull)
                .flatMap(found -> found.lookupAll(".label").stream())
                .map(label -> ((Labeled) label).getText())
                .toList());
    }

    @Test
    void f11FillsTheScreen() {
        try (WindowDriver driver = WindowDriver.open()) {
            driver.type(KeyCode.F11);
            assertThat(driver.stage.isFullScreen()).isTrue();
            driver.type(KeyCode.F11);
            assertThat(driver.stage.isFullScreen()).isFalse();
        }
    }
}
