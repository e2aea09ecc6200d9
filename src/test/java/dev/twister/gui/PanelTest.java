package dev.twister.gui;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import dev.twister.gui.controls.Command;
import dev.twister.gui.controls.Tooltips;
import dev.twister.gui.drawing.DrawnPicture;
import dev.twister.gui.drawing.ResolutionMode;
import dev.twister.gui.edit.BodyEdits;
import dev.twister.gui.edit.BodyMaterials;
import dev.twister.gui.edit.BodyNumber;
import dev.twister.gui.files.WindowSettings;
import dev.twister.gui.panel.ChoiceRow;
import dev.twister.gui.panel.NumberRow;
import dev.twister.gui.panel.Panel;
import dev.twister.gui.panel.PanelRow;
import dev.twister.gui.property.DaylightFile;
import dev.twister.gui.property.DerivedNumbers;
import dev.twister.gui.property.NumberProperty;
import dev.twister.gui.property.PanelNumbers;
import dev.twister.gui.property.PropertyNumbers;
import dev.twister.gui.studio.OpenedScene;
import dev.twister.kernel.Layout;
import dev.twister.scene.Material;
import dev.twister.scene.Scene;
import dev.twister.scene.ToneMap;
import dev.twister.scene.Vector3;
import dev.twister.scene.property.Property;
import dev.twister.scene.property.SceneProperties;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import javafx.geometry.Bounds;
import javafx.scene.Group;
import javafx.scene.Node;
import javafx.scene.control.Button;
import javafx.scene.control.ColorPicker;
import javafx.scene.control.ComboBox;
import javafx.scene.control.ComboBoxBase;
import javafx.scene.control.Hyperlink;
import javafx.scene.control.Label;
import javafx.scene.control.ListView;
import javafx.scene.control.MenuBar;
import javafx.scene.control.MenuItem;
import javafx.scene.control.TextField;
import javafx.scene.control.Tooltip;
import javafx.scene.input.KeyCode;
import javafx.scene.input.KeyCombination;
import javafx.scene.input.MouseButton;
import javafx.scene.layout.Pane;
import javafx.stage.Window;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** Each control of the panel, used by hand. One window for all: every test starts from the scene as it was opened. */
class PanelTest {
    private static final int SPHERE = Layout.FIRST_SPHERE + 1;
    private static final int SOME_COLOR = 40;
    private static WindowDriver driver;

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
        driver.type(Command.RESET.keys());
        driver.clearNotice();
        driver.run(() -> driver.studio.refiningProperty().set(false));
        driver.run(() -> driver.studio.selection().select(SPHERE));
        assertThat(scene()).isEqualTo(WindowDriver.call(driver.studio.document()::original));
    }

    private static Stream<Stream<NumberProperty<Scene>>> kindsOfNumbers() {
        return Stream.of(
                PropertyNumbers.of(Property.within(SceneProperties.RENDERING, Scene::rendering, Scene::withRendering))
                        .stream(),
                PanelNumbers.ofCamera().stream().skip(5),
                PanelNumbers.ofLight(0).stream().limit(7),
                PropertyNumbers.of(Property.within(SceneProperties.SKY, Scene::sky, Scene::withSky)).stream(),
                PropertyNumbers.ofBody(scene(), SPHERE).stream(),
                PanelNumbers.ofMaterial().stream()
                        .filter(number -> !number.label().startsWith("Opacity"))
                        .map(PanelTest::ofSphere));
    }

    private static NumberProperty<Scene> ofSphere(NumberProperty<Material> number) {
        return number.in(
                scene -> BodyMaterials.of(scene, SPHERE), (scene, edit) -> BodyMaterials.edited(scene, SPHERE, edit));
    }

    /** The first of each kind. */
    static Stream<NumberProperty<Scene>> numbers() {
        return kindsOfNumbers().flatMap(kind -> kind.limit(1));
    }

    static Stream<NumberProperty<Scene>> allNumbers() {
        return kindsOfNumbers().flatMap(kind -> kind);
    }

    private static Scene scene() {
        return WindowDriver.call(driver.studio::scene);
    }

    private static PanelRow row(String label) {
        return WindowDriver.call(() -> driver.window.workbench().panel().rows().stream()
                .filter(row -> row.name().equals(label))
                .findFirst()
                .orElseThrow());
    }

    private static <T extends Node> T in(PanelRow row, String selector, Class<T> kind) {
        return WindowDriver.call(() -> kind.cast(row.lookup(selector)));
    }

    private static void typeText(TextField field, String text) {
        driver.run(field::requestFocus);
        driver.typeWith(KeyCode.A, KeyCode.CONTROL);
        driver.run(() -> field.replaceSelection(text));
        driver.type(KeyCode.ENTER);
    }

    @Test
    void resetLeavesTheSliderAloneThatHasTheFocus() {
        driver.type(row("Light x").keys());
        driver.press(KeyCode.CONTROL, KeyCode.SHIFT, KeyCode.HOME);
        // Fingers leave the keys in any order.
        driver.release(KeyCode.CONTROL, KeyCode.SHIFT, KeyCode.HOME);

        assertThat(scene()).isEqualTo(WindowDriver.call(driver.studio.document()::original));
    }

    @Test
    void undoTakesBackWhatWasTypedInAField() {
        Scene before = scene();
        TextField field = in(row("Shadow samples"), ".text-field", TextField.class);
        typeText(field, "50");
        assertThat(scene().rendering().shadowSamples()).isEqualTo(50);

        driver.type(Command.UNDO.keys());
        assertThat(scene()).isEqualTo(before);
        String shown = WindowDriver.call(field::getText);
        assertThat(shown).isEqualTo(String.valueOf(before.rendering().shadowSamples()));
        driver.type(Command.REDO.keys());
        assertThat(scene().rendering().shadowSamples()).isEqualTo(50);

        // What is still being typed is the field's own.
        driver.run(field::requestFocus);
        driver.typeWith(KeyCode.A, KeyCode.CONTROL);
        driver.run(() -> field.replaceSelection("7"));
        driver.type(Command.UNDO.keys());
        assertThat(scene().rendering().shadowSamples()).isEqualTo(50);
        driver.type(KeyCode.ESCAPE);
    }

    @Test
    void whatIsTypedForASphereIsForNoOther() {
        Scene before = scene();
        TextField field = in(row("Sphere radius"), ".text-field", TextField.class);
        driver.run(field::requestFocus);
        driver.typeWith(KeyCode.A, KeyCode.CONTROL);
        driver.run(() -> field.replaceSelection("0.7"));
        driver.run(() -> {
            MenuBar menu = (MenuBar) driver.stage.getScene().lookup(".menu-bar");
            menu.getMenus().stream()
                    .flatMap(group -> group.getItems().stream())
                    .filter(item -> "menu-delete".equals(item.getId()))
                    .forEach(MenuItem::fire);
        });
        driver.pulse();
        assertThat(scene().spheres())
                .isEqualTo(BodyEdits.deleted(before, SPHERE).spheres());
    }

    @Test
    void thePanelScrollsToTheControlsOfWhatIsSelected() {
        Panel panel = WindowDriver.call(() -> driver.window.workbench().panel());
        double height = WindowDriver.call(driver.stage::getHeight);
        driver.run(() -> {
            driver.stage.setHeight(height / 2);
            driver.studio.selection().select(Layout.NOTHING);
            panel.setVvalue(0);
        });
        driver.await(() -> panel.getHeight() < height / 2);
        driver.pulse();
        assertThat(isSeen(panel, driver.find("#reset-everything", Button.class)))
                .isFalse();

        driver.run(() -> driver.studio.selection().select(SPHERE));
        driver.pulse();
        assertThat(isSeen(panel, row("Sphere radius"))).isTrue();

        driver.run(() -> {
            panel.setVvalue(1);
            driver.studio.selection().select(BodyNumber.LIGHT);
        });
        driver.pulse();
        assertThat(isSeen(panel, row("Light x"))).isTrue();
        driver.run(() -> driver.stage.setHeight(height));
    }

    private static boolean isSeen(Panel panel, Node node) {
        return WindowDriver.call(() ->
                panel.localToScreen(panel.getLayoutBounds()).contains(node.localToScreen(node.getLayoutBounds())));
    }

    @Test
    void aLongNumberIsSeenWhole() {
        driver.run(() ->
                driver.studio.edit("a place", scene -> BodyEdits.moved(scene, SPHERE, new Vector3(-12345.678, 0, 0))));
        driver.pulse();

        TextField field = in(row("Sphere x"), ".text-field", TextField.class);
        String shown = WindowDriver.call(field::getText);
        assertThat(shown).isEqualTo("-12345.68");
        double text =
                WindowDriver.call(() -> field.lookup(".text").getLayoutBounds().getWidth());
        double room = WindowDriver.call(() -> field.getWidth()
                - field.getInsets().getLeft()
                - field.getInsets().getRight());
        assertThat(text).isLessThanOrEqualTo(room);
    }

    @ParameterizedTest
    @MethodSource("numbers")
    void aNumberIsSlidTypedAndReset(NumberProperty<Scene> setting) {
        slideTypeAndReset(setting);
    }

    @Tag("slow")
    @ParameterizedTest
    @MethodSource("allNumbers")
    void everyNumberIsSlidTypedAndReset(NumberProperty<Scene> setting) {
        slideTypeAndReset(setting);
    }

    private static void slideTypeAndReset(NumberProperty<Scene> setting) {
        PanelRow row = row(setting.label());
        TextField field = in(row, ".text-field", TextField.class);
        Button reset = in(row, ".reset", Button.class);
        double before = setting.read(scene());
        assertThat(reset.isDisabled()).isTrue();

        goTo(row);
        boolean atTheEnd = before >= setting.scale().around(before).slid().max();
        driver.type(atTheEnd ? KeyCode.LEFT : KeyCode.RIGHT);
        double slid = setting.read(scene());
        assertThat(slid - before).matches(moved -> atTheEnd ? moved < 0 : moved > 0);
        assertThat(field.getText()).isEqualTo(setting.scale().text(slid));
        driver.awaitCurrentPicture();

        double other = setting.scale().numberAt(0.8);
        typeText(field, setting.scale().text(other));
        assertThat(setting.read(scene())).isCloseTo(other, within(1e-9));

        driver.click(reset);
        assertThat(setting.read(scene())).isEqualTo(before);
        assertThat(reset.isDisabled()).isTrue();
    }

    @Test
    void aSliderIsDraggedAndThatIsOneEdit() {
        NumberRow row = (NumberRow) row("Exposure");
        Node slider = row.firstControl();
        driver.type(row.keys());
        DrawnPicture before = driver.awaitCurrentPicture();
        long darkness = brightness(before);
        var bounds = WindowDriver.call(() -> slider.localToScreen(slider.getLayoutBounds()));
        double middle = bounds.getCenterX();
        double y = bounds.getCenterY();
        driver.withRobot(hand -> hand.mouseMove(middle, y));
        driver.withRobot(hand -> hand.mousePress(MouseButton.PRIMARY));
        for (int i = 1; i <= 5; i++) {
            double x = middle + 4 * i;
            driver.withRobot(hand -> hand.mouseMove(x, y));
        }
        driver.withRobot(hand -> hand.mouseRelease(MouseButton.PRIMARY));
        assertThat(scene().rendering().exposure()).isBetween(0.5, 6.0);
        assertThat(brightness(driver.awaitCurrentPicture())).isGreaterThan(darkness);
        driver.typeWith(KeyCode.Z, KeyCode.CONTROL);
        assertThat(scene().rendering().exposure()).isZero();
        driver.typeWith(KeyCode.Z, KeyCode.CONTROL, KeyCode.SHIFT);
        assertThat(scene().rendering().exposure()).isGreaterThan(0.5);
        driver.typeWith(KeyCode.Z, KeyCode.CONTROL);
        driver.typeWith(KeyCode.Y, KeyCode.CONTROL);
        assertThat(scene().rendering().exposure()).isGreaterThan(0.5);
    }

    @Test
    void theSelectedSpheresNumberFollowsItsSlider() {
        NumberRow row = (NumberRow) row("Reflectivity");
        TextField field = in(row, ".text-field", TextField.class);
        NumberProperty<Scene> setting = ofSphere(DerivedNumbers.REFLECTIVITY);
        String before = WindowDriver.call(field::getText);
        driver.type(row.keys());
        driver.pulse();
        Node thumb = WindowDriver.call(() -> row.firstControl().lookup(".thumb"));
        var bounds = WindowDriver.call(() -> thumb.localToScreen(thumb.getLayoutBounds()));
        driver.withRobot(hand -> hand.mouseMove(bounds.getCenterX(), bounds.getCenterY()));
        driver.withRobot(hand -> hand.mousePress(MouseButton.PRIMARY));
        driver.withRobot(hand -> hand.mouseMove(bounds.getCenterX() + 10, bounds.getCenterY()));
        assertThat(field.getText())
                .isNotEqualTo(before)
                .isEqualTo(setting.scale().text(setting.read(scene())));

        driver.withRobot(hand -> hand.mouseMove(bounds.getCenterX() + 20, bounds.getCenterY()));
        driver.withRobot(hand -> hand.mouseRelease(MouseButton.PRIMARY));
        assertThat(field.getText()).isEqualTo(setting.scale().text(setting.read(scene())));
        driver.click(in(row, ".reset", Button.class));
        assertThat(field.getText()).isEqualTo(before);
    }

    private static long brightness(DrawnPicture picture) {
        long sum = 0;
        for (int argb : picture.frame().argb()) {
            sum += (argb >> 8) & 255;
        }
        return sum / picture.frame().argb().length;
    }

    @Test
    void whatIsNoNumberIsSaidAndNotTaken() {
        PanelRow row = row("Shadow samples");
        TextField field = in(row, ".text-field", TextField.class);
        typeText(field, "many");
        assertThat(driver.notice()).isEqualTo("Shadow samples is 'many', but must be a number from 1 to 1024");
        assertThat(scene()).isEqualTo(WindowDriver.call(driver.studio.document()::original));
        driver.type(KeyCode.ESCAPE);
        assertThat(field.getText()).isEqualTo("1");
        assertThat(driver.text("notice")).isEmpty();
    }

    @Test
    void whatIsSaidOfAWrongNumberIsGoneOnceItIsMended() {
        TextField field = in(row("Shadow samples"), ".text-field", TextField.class);
        typeText(field, "0");
        assertThat(driver.text("notice")).startsWith("Shadow samples is '0'");
        assertThat(field.isFocused()).isTrue();
        typeText(field, "2");
        assertThat(driver.text("notice")).isEmpty();
    }

    @Test
    void enterLeadsBackToThePicture() {
        typeText(in(row("Shadow samples"), ".text-field", TextField.class), "2");
        assertThat(driver.find(".picture", Node.class).isFocused()).isTrue();
        driver.type(row("Exposure").keys());
        driver.type(KeyCode.ENTER);
        assertThat(driver.find(".picture", Node.class).isFocused()).isTrue();
    }

    private static double sphereX() {
        return scene().spheres().get(SPHERE - Layout.FIRST_SPHERE).position().x();
    }

    @Test
    void arrowKeysAreFinerWithShiftAndControl() {
        double before = sphereX();
        driver.type(row("Sphere x").keys());
        driver.type(KeyCode.RIGHT);
        assertThat(sphereX()).isCloseTo(before + 0.1, within(1e-9));
        driver.typeWith(KeyCode.RIGHT, KeyCode.SHIFT);
        assertThat(sphereX()).isCloseTo(before + 0.11, within(1e-9));
        driver.typeWith(KeyCode.LEFT, KeyCode.CONTROL);
        assertThat(sphereX()).isCloseTo(before + 0.1, within(1e-9));
    }

    @Test
    void aNumberIsDraggedByItsNameAndThatIsOneEdit() {
        double before = sphereX();
        driver.type(row("Sphere x").keys());
        Label name = in(row("Sphere x"), ".row-name", Label.class);
        Bounds place = WindowDriver.call(() -> name.localToScreen(name.getLayoutBounds()));
        driver.withRobot(hand -> hand.mouseMove(place.getMinX() + 5, place.getCenterY()));
        driver.withRobot(hand -> hand.mousePress(MouseButton.PRIMARY));
        for (int step = 1; step <= 4; step++) {
            double x = place.getMinX() + 5 + 10 * step;
            driver.withRobot(hand -> hand.mouseMove(x, place.getCenterY()));
        }
        driver.withRobot(hand -> hand.mouseRelease(MouseButton.PRIMARY));
        assertThat(sphereX()).isCloseTo(before + 1, within(0.011));
        driver.type(Command.UNDO.keys());
        assertThat(sphereX()).isEqualTo(before);
    }

    @Test
    void theFieldOfViewIsTakenBackByName() {
        Scene before = scene();
        typeText(in(row("Field of view"), ".text-field", TextField.class), "33");
        assertThat(scene().camera().fieldOfViewDegrees()).isEqualTo(33);
        driver.type(Command.UNDO.keys());
        assertThat(scene()).isEqualTo(before);
        assertThat(driver.notice()).isEqualTo("Undone: field of view");
        driver.type(Command.REDO.keys());
        assertThat(scene().camera().fieldOfViewDegrees()).isEqualTo(33);
        assertThat(driver.notice()).isEqualTo("Redone: field of view");
    }

    @Tag("slow")
    @Test
    void anEngineIsChosenAndReset() {
        driver.await(
                () -> ((ComboBox<?>) row("Engine").firstControl()).getItems().size() > 3);
        driver.type(row("Engine").keys());
        String before = WindowDriver.call(
                () -> driver.studio.engineProperty().get().offer().id());
        driver.type(KeyCode.UP);
        String chosen = WindowDriver.call(
                () -> driver.studio.engineProperty().get().offer().id());
        assertThat(chosen).isNotEqualTo(before);
        driver.awaitPicture(picture -> picture.engine().equals(chosen));
        driver.click(in(row("Engine"), ".reset", Button.class));
        driver.awaitPicture(picture -> picture.engine().equals(before));
        // The list has the engine of that name that draws every pixel.
        driver.run(() -> driver.studio.chooseEngine(BlockEngine.offer()));
    }

    @Test
    void enginesThatCannotRunAreGrayWithTheReason() {
        ComboBox<String> box = WindowDriver.call(() -> {
            @SuppressWarnings("unchecked")
            ComboBox<String> engines = (ComboBox<String>) row("Engine").firstControl();
            return engines;
        });
        assertThat(box.getItems()).isNotEmpty();
        ChoiceRow<String> row = WindowDriver.call(() -> new ChoiceRow<String>(
                "Test",
                "Some work.",
                "Alt+Q",
                name -> new ChoiceRow.Look(
                        name, name, "", name.equals("broken") ? Optional.of("no driver") : Optional.empty()),
                _ -> {},
                driver.studio::notice));
        driver.run(() -> {
            row.show(List.of("good", "broken"), "good", "good");
            @SuppressWarnings("unchecked")
            ComboBox<String> choice = (ComboBox<String>) row.firstControl();
            choice.getSelectionModel().select("broken");
            assertThat(choice.getValue()).isEqualTo("good");
        });
        assertThat(driver.notice()).isEqualTo("broken: no driver");
        assertThat(Tooltips.wrap("no TornadoVM SDK was found. Install one (sdk install tornadovm) and start again"))
                .isEqualTo("no TornadoVM SDK was found. Install one (sdk install\ntornadovm) and start again");
    }

    @Test
    void aListThatIsOpenGrowsWithItsThings() {
        ChoiceRow<String> row = WindowDriver.call(() ->
                new ChoiceRow<>("Test", "Some work.", "Alt+Q", ChoiceRow.Look::new, _ -> {}, driver.studio::notice));
        ComboBox<?> list = (ComboBox<?>) row.firstControl();
        Pane place = WindowDriver.call(() -> (Pane) row("Engine").getParent());
        driver.run(() -> {
            place.getChildren().add(row);
            row.show(List.of("one", "two"), "one", "one");
        });
        driver.pulse();
        driver.run(list::show);
        driver.pulse();
        double before = openListHeight();

        driver.run(() -> row.show(List.of("one", "two", "three", "four"), "one", "one"));
        driver.pulse();
        assertThat(openListHeight()).isCloseTo(2 * before, within(before / 4));

        driver.run(() -> {
            list.hide();
            place.getChildren().remove(row);
        });
    }

    private static double openListHeight() {
        return WindowDriver.call(() -> Window.getWindows().stream()
                .filter(Window::isShowing)
                .flatMap(window -> window.getScene().getRoot().lookupAll(".combo-box-popup .list-view").stream())
                .mapToDouble(view -> view.getLayoutBounds().getHeight())
                .max()
                .orElseThrow());
    }

    @Test
    void aResolutionIsChosenAndThePictureScaled() {
        driver.type(row("Resolution").keys());
        driver.type(KeyCode.DOWN);
        DrawnPicture picture = driver.awaitPicture(drawn -> drawn.frame().width() == 1280 && drawn.isWhole());
        assertThat(picture.frame().height()).isEqualTo(720);
        assertThat(driver.pictureOnScreen().getWidth()).isLessThan(1000);
        driver.click(in(row("Resolution"), ".reset", Button.class));
        assertThat(WindowDriver.call(driver.studio.resolutionProperty()::get)).isEqualTo(ResolutionMode.WINDOW);
        driver.awaitPicture(drawn -> drawn.frame().width() < 1000);
    }

    @Test
    void aToneMapAndTheSrgbCurveAreChosen() {
        long clamped = brightness(driver.awaitCurrentPicture());
        driver.type(row("Tone map").keys());
        driver.type(KeyCode.DOWN);
        assertThat(scene().rendering().toneMap()).isEqualTo(ToneMap.REINHARD);
        long mapped = brightness(driver.awaitCurrentPicture());
        assertThat(mapped).isLessThan(clamped);
        driver.type(row("sRGB curve").keys());
        driver.type(KeyCode.SPACE);
        assertThat(scene().rendering().srgb()).isFalse();
        assertThat(brightness(driver.awaitCurrentPicture())).isLessThan(mapped);
        driver.click(in(row("sRGB curve"), ".reset", Button.class));
        driver.click(in(row("Tone map"), ".reset", Button.class));
        assertThat(scene()).isEqualTo(WindowDriver.call(driver.studio.document()::original));
    }

    @Test
    void refiningIsSwitched() {
        driver.run(() -> driver.studio.refiningProperty().set(true));
        driver.type(row("Refine at rest").keys());
        driver.type(KeyCode.SPACE);
        assertThat(WindowDriver.call(driver.studio.refiningProperty()::get)).isFalse();
        driver.click(in(row("Refine at rest"), ".reset", Button.class));
        assertThat(WindowDriver.call(driver.studio.refiningProperty()::get)).isTrue();
    }

    @Tag("slow")
    @Test
    void colorsAreChosenFromThePalette() {
        for (String label : List.of("Light color", "Color")) {
            PanelRow row = row(label);
            Scene before = scene();
            ColorPicker picker = openPalette(row);
            driver.click(WindowDriver.call(() -> Window.getWindows().stream()
                    .flatMap(window -> window.getScene().getRoot().lookupAll(".color-square").stream())
                    .skip(SOME_COLOR)
                    .findFirst()
                    .orElseThrow()));
            assertThat(scene()).as(label).isNotEqualTo(before);
            driver.awaitCurrentPicture();
            driver.run(picker::hide);
            driver.click(in(row, ".reset", Button.class));
            assertThat(scene()).as(label).isEqualTo(before);
        }
    }

    private ColorPicker openPalette(PanelRow row) {
        ColorPicker picker = (ColorPicker) row.firstControl();
        driver.type(row.keys());
        driver.type(KeyCode.F4);
        driver.await(picker::isShowing);
        driver.pulse();
        return picker;
    }

    @Tag("slow")
    @Test
    void aDragInTheDialogOfCustomColorsIsOneEdit() {
        PanelRow row = row("Light color");
        Scene before = scene();
        ColorPicker picker = openPalette(row);
        driver.run(() -> inOpenWindows(".hyperlink", Hyperlink.class).fire());
        driver.pulse();
        Node colors = WindowDriver.call(() -> inOpenWindows(".color-rect-border", Node.class));
        assertThat(WindowDriver.call(() -> inOpenWindows("#settings-pane", Pane.class).getChildren().stream()
                        .filter(Node::isVisible)
                        .filter(Label.class::isInstance)
                        .map(label -> ((Label) label).getText())
                        .toList()))
                .doesNotContain("Opacity:")
                .contains("Hue:");
        Bounds place = WindowDriver.call(() -> colors.localToScreen(colors.getLayoutBounds()));
        List<Scene> seen = new ArrayList<>();
        driver.withRobot(hand -> hand.mouseMove(place.getCenterX(), place.getCenterY()));
        driver.withRobot(hand -> hand.mousePress(MouseButton.PRIMARY));
        for (int step = 1; step <= 3; step++) {
            double away = 10.0 * step;
            driver.withRobot(hand -> hand.mouseMove(place.getCenterX() + away, place.getCenterY() - away));
            seen.add(scene());
        }
        driver.withRobot(hand -> hand.mouseRelease(MouseButton.PRIMARY));
        driver.run(() -> colors.getScene().getWindow().hide());
        driver.run(picker::hide);

        assertThat(seen).doesNotHaveDuplicates().doesNotContain(before);
        driver.type(Command.UNDO.keys());
        assertThat(scene()).isEqualTo(before);
    }

    private static <T extends Node> T inOpenWindows(String selector, Class<T> kind) {
        return Window.getWindows().stream()
                .filter(Window::isShowing)
                .flatMap(window -> window.getScene().getRoot().lookupAll(selector).stream())
                .map(kind::cast)
                .findFirst()
                .orElseThrow();
    }

    @Tag("slow")
    @Test
    void spaceOpensListsAndPalettesAndEscapeClosesThemAndNoMore() {
        for (String label : List.of("Resolution", "Light color", "Color")) {
            PanelRow row = row(label);
            ComboBoxBase<?> control = (ComboBoxBase<?>) row.firstControl();
            driver.type(row.keys());
            driver.type(KeyCode.SPACE);
            driver.pulse();
            assertThat(control.isShowing()).as(label).isTrue();

            driver.type(KeyCode.ESCAPE);
            driver.pulse();
            assertThat(control.isShowing()).as(label).isFalse();
            assertThat(control.isFocused()).as(label).isTrue();
            assertThat(WindowDriver.call(driver.studio.selection()::active)).isEqualTo(SPHERE);
        }
    }

    @Test
    void aSkyIsChosenFromTheList() {
        driver.await(() -> ((ComboBox<?>) row("Sky").firstControl()).getItems().size() >= 3);
        long before = brightness(driver.awaitCurrentPicture());
        driver.type(row("Sky").keys());
        driver.type(KeyCode.DOWN);
        driver.await(() -> !driver.studio
                .scene()
                .sky()
                .file()
                .equals(driver.studio.document().original().sky().file()));
        assertThat(brightness(driver.awaitCurrentPicture())).isNotEqualTo(before);
        driver.click(in(row("Sky"), ".reset", Button.class));
        driver.await(() -> driver.studio
                .scene()
                .sky()
                .file()
                .equals(driver.studio.document().original().sky().file()));
    }

    @Test
    void aDaylightNumberIsNotResetWhereTheSkyIsOfAnotherKind() {
        Scene day = WindowDriver.call(driver.studio::scene);
        Scene evening = new DaylightFile(8, -60, 3, 0).in(day);
        driver.run(() -> {
            driver.studio.show(new OpenedScene(Path.of("test.json"), evening));
            driver.studio.edit("sky", scene -> scene.withSky(day.sky()));
        });
        assertThat(in(row("Sun height"), ".reset", Button.class).isDisabled()).isTrue();
        driver.run(() -> driver.studio.show(new OpenedScene(Path.of("test.json"), day)));
    }

    @Test
    void everyRowHasATooltipWithItsOwnKey() {
        List<PanelRow> rows =
                WindowDriver.call(() -> driver.window.workbench().panel().rows());
        assertThat(rows).hasSizeGreaterThan(20);
        List<KeyCombination> keys =
                rows.stream().map(PanelRow::keys).filter(PanelTest::isKey).toList();
        assertThat(keys).doesNotHaveDuplicates();
        assertThat(rows.stream().map(Node::getId)).doesNotHaveDuplicates();
        for (PanelRow row : rows) {
            Tooltip tooltip = in(row, ".row-name", Label.class).getTooltip();
            assertThat(tooltip.getText()).contains(row.keys().getDisplayText());
        }
        for (Command command : Command.values()) {
            assertThat(keys).doesNotContain(command.keys());
        }
    }

    /** Some rows have none. */
    private static boolean isKey(KeyCombination keys) {
        return !keys.getDisplayText().isEmpty();
    }

    private static void goTo(PanelRow row) {
        if (isKey(row.keys())) {
            driver.type(row.keys());
        } else {
            driver.run(() -> driver.window.workbench().panel().scrollTo(row));
            driver.run(row.firstControl()::requestFocus);
        }
    }

    @Test
    void tabLeavesThePictureAndThePanelStays() {
        driver.run(() -> driver.find(".picture", Pane.class).requestFocus());
        driver.type(KeyCode.TAB);
        assertThat(driver.find(".picture", Pane.class).isFocused()).isFalse();
        assertThat(driver.window.workbench().panel().isVisible()).isTrue();
    }

    @Test
    void stepsOfASliderByKeysAreUndoneTogether() {
        Scene before = scene();
        driver.type(row("Exposure").keys());
        driver.type(KeyCode.RIGHT);
        driver.type(KeyCode.RIGHT);
        driver.type(KeyCode.RIGHT);
        assertThat(scene()).isNotEqualTo(before);
        driver.type(Command.UNDO.keys());
        assertThat(scene()).isEqualTo(before);
    }

    @Tag("slow")
    @Test
    void everyControlComesIntoSightByItsKey() {
        for (PanelRow row :
                WindowDriver.call(() -> driver.window.workbench().panel().rows())) {
            if (!isKey(row.keys())) {
                continue;
            }
            driver.type(row.keys());
            assertThat(row.firstControl().isFocused()).as(row.name()).isTrue();
            var panel = WindowDriver.call(() -> driver.window
                    .workbench()
                    .panel()
                    .localToScene(driver.window.workbench().panel().getLayoutBounds()));
            var place = WindowDriver.call(() -> row.localToScene(row.getLayoutBounds()));
            assertThat(panel.contains(place.getCenterX(), place.getCenterY()))
                    .as(row.name())
                    .isTrue();
        }
    }

    @Test
    void f9ShowsAndHidesThePanelAndEscapeLeavesIt() {
        Panel panel = driver.window.workbench().panel();
        driver.type(row("Exposure").keys());
        driver.type(KeyCode.TAB);
        assertThat(in(row("Exposure"), ".text-field", TextField.class).isFocused())
                .isTrue();
        driver.type(KeyCode.ESCAPE);
        assertThat(driver.find(".picture", Node.class).isFocused()).isTrue();
        driver.type(KeyCode.F9);
        assertThat(panel.isVisible()).isFalse();
        driver.type(KeyCode.F9);
        assertThat(panel.isVisible()).isTrue();
        driver.type(KeyCode.F9);
        assertThat(panel.isVisible()).isFalse();
        driver.type(row("Exposure").keys());
        assertThat(panel.isVisible()).isTrue();
    }

    @Test
    void keysThatDoNothingSayWhy() {
        driver.type(KeyCode.ESCAPE);
        driver.run(() -> driver.studio.selection().select(BodyNumber.LIGHT));
        driver.type(KeyCode.DELETE);
        assertThat(driver.notice()).isEqualTo("The last light can't be deleted; a scene has at least one");
        driver.run(() -> driver.studio.selection().select(Layout.NOTHING));
        driver.type(KeyCode.DELETE);
        assertThat(driver.notice()).isEqualTo("Nothing is selected");
        driver.run(() -> driver.studio.show(
                new OpenedScene(Path.of("test.json"), driver.studio.document().original())));
        driver.type(Command.UNDO.keys());
        assertThat(driver.notice()).isEqualTo("Nothing to undo");
        driver.type(Command.REDO.keys());
        assertThat(driver.notice()).isEqualTo("Nothing to redo");
    }

    @Test
    void everythingIsResetAtOnceAndThatCanBeUndone() {
        driver.type(row("Exposure").keys());
        driver.type(KeyCode.RIGHT);
        driver.type(row("Light x").keys());
        driver.type(KeyCode.RIGHT);
        Scene edited = scene();
        driver.run(() -> driver.studio.refiningProperty().set(true));
        driver.type(row("Refine at rest").keys());
        driver.type(KeyCode.SPACE);
        driver.run(() -> driver.window.workbench().panel().setVvalue(1));
        driver.pulse();
        driver.click(driver.find("#reset-everything", Button.class));
        assertThat(scene()).isEqualTo(WindowDriver.call(driver.studio.document()::original));
        assertThat(WindowDriver.call(driver.studio.refiningProperty()::get)).isTrue();
        driver.typeWith(KeyCode.Z, KeyCode.CONTROL);
        assertThat(scene()).isEqualTo(edited);
    }

    @Tag("slow")
    @Test
    void theLightThePlaneAndEverySphereAreSelectedByKeys() {
        driver.run(() -> driver.studio.selection().select(Layout.NOTHING));
        int spheres = scene().spheres().size();
        List<Integer> round = new ArrayList<>(List.of(BodyNumber.LIGHT, Layout.PLANE));
        for (int sphere = 0; sphere < spheres; sphere++) {
            round.add(Layout.FIRST_SPHERE + sphere);
        }
        round.add(Layout.NOTHING);

        for (int body : round) {
            driver.type(Command.NEXT.keys());
            assertThat(WindowDriver.call(driver.studio.selection()::active)).isEqualTo(body);
        }
        for (int body : round.subList(0, round.size() - 1).reversed()) {
            driver.type(Command.PREVIOUS.keys());
            assertThat(WindowDriver.call(driver.studio.selection()::active)).isEqualTo(body);
        }
        driver.type(Command.PREVIOUS.keys());
        assertThat(WindowDriver.call(driver.studio.selection()::active)).isEqualTo(Layout.NOTHING);
    }

    @Test
    void severalBodiesAreSelectedInTheList() {
        driver.type(row("Bodies").keys());
        driver.type(KeyCode.HOME);
        assertThat(WindowDriver.call(driver.studio.selection()::active)).isEqualTo(BodyNumber.LIGHT);
        driver.type(KeyCode.DOWN);
        assertThat(WindowDriver.call(driver.studio.selection()::active)).isEqualTo(Layout.PLANE);
        driver.type(KeyCode.DOWN);
        driver.typeWith(KeyCode.DOWN, KeyCode.SHIFT);
        assertThat(WindowDriver.call(() -> driver.studio.selection().bodies().bodies()))
                .containsExactly(Layout.FIRST_SPHERE, Layout.FIRST_SPHERE + 1);
        assertThat(driver.text("selection-hint"))
                .startsWith("2 bodies are selected.")
                .endsWith("of Sphere 2.");
        driver.type(KeyCode.ESCAPE);
        assertThat(WindowDriver.call(() -> row("Bodies").firstControl().isFocused()))
                .isFalse();
    }

    @Test
    void aBodyIsRenamedInTheList() {
        driver.type(row("Bodies").keys());
        driver.type(KeyCode.HOME);
        driver.type(KeyCode.DOWN);
        driver.type(KeyCode.DOWN);
        driver.type(KeyCode.F2);
        TextField field = driver.find("#body-name", TextField.class);
        assertThat(field.isFocused()).isTrue();
        driver.run(() -> field.setText("Ball"));
        driver.type(KeyCode.ENTER);
        assertThat(scene().spheres().getFirst().tag().name()).isEqualTo("Ball");
        assertThat(driver.text("selection-hint")).startsWith("Ball. ");
    }

    @Test
    void aHiddenBodyIsNotInThePictureAndTheOthersStayWhatTheyAre() {
        driver.run(() -> driver.studio.selection().select(SPHERE));
        driver.type(Command.HIDE.keys());
        DrawnPicture picture = driver.awaitCurrentPicture();
        assertThat(picture.request().scene().spheres())
                .hasSize(scene().spheres().size() - 1);
        assertThat(WindowDriver.call(() -> driver.studio.picturedBodies().orElseThrow())
                        .inScene(SPHERE))
                .isEqualTo(SPHERE + 1);
        driver.type(Command.SHOW_ALL.keys());
        assertThat(driver.awaitCurrentPicture().request().scene().spheres()).hasSameSizeAs(scene().spheres());
    }

    @Test
    void theListMarksWhatIsSelectedElsewhere() {
        driver.run(() -> driver.studio.selection().select(List.of(BodyNumber.LIGHT, SPHERE)));
        ListView<?> list = (ListView<?>) row("Bodies").firstControl();
        assertThat(WindowDriver.call(() -> List.copyOf(list.getSelectionModel().getSelectedIndices())))
                .containsExactly(0, SPHERE);
        driver.run(() -> driver.studio.selection().select(Layout.NOTHING));
        assertThat(WindowDriver.call(() -> List.copyOf(list.getSelectionModel().getSelectedIndices())))
                .isEmpty();
    }

    @Test
    void aNumberOfTheMaterialIsGivenToAllSelectedBodies() {
        driver.run(() -> driver.studio.selection().select(List.of(SPHERE, SPHERE + 1)));
        driver.type(row("Roughness").keys());
        driver.type(KeyCode.END);
        assertThat(scene().spheres())
                .extracting(sphere -> sphere.material().roughness())
                .containsExactly(0.0, 1.0, 1.0);
        driver.type(KeyCode.ESCAPE);
        driver.typeWith(KeyCode.Z, KeyCode.CONTROL);
        assertThat(scene()).isEqualTo(WindowDriver.call(driver.studio.document()::original));
    }

    @Test
    void aTypedNumberOfTheMaterialIsOfThoseThatWereSelectedThen() {
        driver.run(() -> driver.studio.selection().select(List.of(SPHERE + 1, SPHERE)));
        TextField field = in(row("Roughness"), ".text-field", TextField.class);
        driver.run(field::requestFocus);
        driver.run(() -> field.setText("0.5"));
        driver.run(() -> driver.studio.selection().select(Layout.FIRST_SPHERE));
        driver.pulse();
        assertThat(scene().spheres())
                .extracting(sphere -> sphere.material().roughness())
                .containsExactly(0.0, 0.5, 0.5);
    }

    @Test
    void theHandlesAreSwitchedOffAndThatIsKept() {
        driver.type(Command.AXIS_HANDLES.keys());
        assertThat(WindowDriver.call(() -> driver.find("#handle-x", Group.class).isVisible()))
                .isFalse();
        assertThat(WindowDriver.call(
                        () -> driver.window.workbench().settings().settings().get(WindowSettings.AXIS_HANDLES)))
                .isFalse();
        driver.type(Command.AXIS_HANDLES.keys());
        assertThat(WindowDriver.call(() -> driver.find("#handle-x", Group.class).isVisible()))
                .isTrue();
    }
}
