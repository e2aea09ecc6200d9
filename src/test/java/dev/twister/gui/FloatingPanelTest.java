package dev.twister.gui;

import static org.assertj.core.api.Assertions.assertThat;

import dev.twister.gui.edit.BodyEdits;
import dev.twister.gui.files.WindowSettings;
import dev.twister.kernel.Layout;
import dev.twister.scene.Scene;
import java.util.List;
import javafx.scene.Node;
import javafx.scene.control.TextField;
import javafx.scene.input.KeyCode;
import javafx.stage.Stage;
import javafx.stage.Window;
import javafx.stage.WindowEvent;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** The panel in a window of its own. */
class FloatingPanelTest {
    private static final int SPHERE = Layout.FIRST_SPHERE;
    private static WindowDriver driver;

    @BeforeAll
    static void open() {
        driver = WindowDriver.open();
    }

    @AfterAll
    static void close() {
        driver.close();
    }

    @BeforeEach
    void floatThePanel() {
        driver.run(() -> {
            driver.studio.selection().select(SPHERE);
            driver.window.workbench().panelWindow().setFloating(true);
            panel().setVisible(true);
            panelStage().requestFocus();
            panel().requestFocus();
        });
    }

    private static Node panel() {
        return driver.window.workbench().panel();
    }

    private static Stage panelStage() {
        return (Stage) driver.window.workbench().panelWindow().scene().getWindow();
    }

    private static Scene scene() {
        return WindowDriver.call(driver.studio::scene);
    }

    private static boolean isShown(Window window) {
        return WindowDriver.call(window::isShowing);
    }

    @Test
    void aKeyMovesThePanelOutAndBack() {
        driver.typeWith(KeyCode.F9, KeyCode.SHIFT);
        assertThat(isShown(panelStage())).isFalse();
        assertThat(panel().getScene()).isEqualTo(driver.stage.getScene());
        assertThat(panel().isVisible()).isTrue();
        driver.typeWith(KeyCode.F9, KeyCode.SHIFT);
        assertThat(isShown(panelStage())).isTrue();
        assertThat(panel().getScene()).isEqualTo(panelStage().getScene());
    }

    @Test
    void closingItsWindowDocksIt() {
        driver.run(() -> panelStage().fireEvent(new WindowEvent(panelStage(), WindowEvent.WINDOW_CLOSE_REQUEST)));
        assertThat(isShown(panelStage())).isFalse();
        assertThat(panel().getScene()).isEqualTo(driver.stage.getScene());
        assertThat(driver.find("#panel-edge", Node.class).isVisible()).isTrue();
    }

    @Test
    void hidingThePanelHidesItsWindow() {
        driver.type(KeyCode.F9);
        assertThat(isShown(panelStage())).isFalse();
        assertThat(driver.find("#panel-edge", Node.class).isVisible()).isFalse();
        driver.type(KeyCode.F9);
        assertThat(isShown(panelStage())).isTrue();
        assertThat(panel().getScene()).isEqualTo(panelStage().getScene());
    }

    @Test
    void keysOfTheMainWindowWorkInIt() {
        driver.type(KeyCode.DELETE);
        assertThat(scene().spheres()).hasSize(2);
        driver.typeWith(KeyCode.Z, KeyCode.CONTROL);
        assertThat(scene().spheres()).hasSize(3);
        assertThat(panelStage().isFocused()).isTrue();
    }

    @Test
    void gMovesTheSelectedBodiesByTypedNumbers() {
        double before = BodyEdits.position(scene(), SPHERE).x();
        driver.type(KeyCode.G);
        driver.type(KeyCode.DIGIT2);
        driver.type(KeyCode.ENTER);
        assertThat(BodyEdits.position(scene(), SPHERE).x()).isEqualTo(before + 2);
        driver.run(driver.studio::undo);
    }

    @Test
    void tabGoesThroughItsControlsAndEscapeToThePicture() {
        Node first = WindowDriver.call(() -> panelStage().getScene().getFocusOwner());
        driver.type(KeyCode.TAB);
        Node second = WindowDriver.call(() -> panelStage().getScene().getFocusOwner());
        assertThat(second).isNotEqualTo(first);
        driver.type(KeyCode.ESCAPE);
        assertThat(driver.find(".picture", Node.class).isFocused()).isTrue();
    }

    @Test
    void lettersTypedInAFieldAreText() {
        driver.run(() -> {
            TextField field = (TextField) panel().lookup(".text-field");
            field.requestFocus();
        });
        driver.type(KeyCode.G);
        driver.type(KeyCode.H);
        assertThat(scene()).isEqualTo(WindowDriver.call(driver.studio.document()::original));
        assertThat(panelStage().isFocused()).isTrue();
    }

    @Test
    void aKeyOfARowLeadsToItFromTheMainWindow() {
        driver.run(driver.stage::requestFocus);
        driver.type(driver.window.workbench().panel().rows().getFirst().keys());
        assertThat(panelStage().isFocused()).isTrue();
    }

    @Test
    void itsPlaceIsKept() {
        driver.run(() -> {
            panelStage().setX(30);
            panelStage().setY(40);
            panelStage().setWidth(400);
            panelStage().setHeight(300);
            driver.window.workbench().panelWindow().setFloating(false);
            panelStage().setX(0);
            panelStage().setWidth(200);
            driver.window.workbench().panelWindow().setFloating(true);
        });
        assertThat(WindowDriver.call(() -> List.of(
                        panelStage().getX(),
                        panelStage().getY(),
                        panelStage().getWidth(),
                        panelStage().getHeight())))
                .containsExactly(30.0, 40.0, 400.0, 300.0);
        assertThat(WindowSettings.Bounds.of(driver.window.workbench().settings().settings()))
                .contains(new WindowSettings.Bounds(30, 40, 400, 300));
    }
}
