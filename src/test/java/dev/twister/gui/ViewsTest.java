package dev.twister.gui;

import static org.assertj.core.api.Assertions.assertThat;

import dev.twister.gui.controls.Command;
import dev.twister.gui.studio.OpenedScene;
import dev.twister.kernel.Layout;
import dev.twister.scene.CameraView;
import dev.twister.scene.Scene;
import java.nio.file.Path;
import java.util.List;
import javafx.geometry.Point2D;
import javafx.scene.Node;
import javafx.scene.control.Button;
import javafx.scene.control.ListCell;
import javafx.scene.control.ListView;
import javafx.scene.control.TextField;
import javafx.scene.input.KeyCode;
import javafx.scene.input.MouseButton;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

/** The list of views in the panel. */
class ViewsTest {
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
        driver.run(() -> driver.studio.show(new OpenedScene(Path.of("test.json"), WindowScenes.tiny())));
        driver.awaitCurrentPicture();
    }

    @Test
    void aViewIsAddedAndNamedInItsLine() {
        press("add");
        assertThat(names()).containsExactly("View 1");
        assertThat(focusOwner()).isInstanceOf(TextField.class);
        // Letters and the space that are commands elsewhere.
        typeName("Jack x.");
        driver.type(KeyCode.ENTER);

        assertThat(names()).containsExactly("Jack x.");
        assertThat(driver.studio.film().playingProperty().get()).isFalse();
        assertThat(scene().camera().keyframes()).isEmpty();
        assertThat(focusOwner()).isInstanceOf(ListView.class);
        assertThat(cellText(0)).isEqualTo("1   Jack x.");
        driver.type(Command.UNDO.keys());
        assertThat(names()).containsExactly("View 1");
        driver.type(Command.UNDO.keys());
        assertThat(names()).isEmpty();
    }

    @Tag("slow")
    @Test
    void plainKeysAreLettersWhileANameIsTyped() {
        press("add");
        driver.type(KeyCode.K);
        driver.type(KeyCode.J);
        driver.type(KeyCode.SPACE);
        driver.type(KeyCode.DIGIT1);
        driver.type(KeyCode.PERIOD);

        assertThat(scene().camera().keyframes()).isEmpty();
        assertThat(driver.find("#clipping", Node.class).isVisible()).isFalse();
        assertThat(driver.studio.film().playingProperty().get()).isFalse();
        assertThat(focusOwner()).isInstanceOf(TextField.class);
    }

    @Test
    void enterAndADoubleClickGoToAView() {
        CameraView view = add();
        driver.run(() -> driver.studio.moveCamera(camera -> camera.withYawDegrees(80)));
        driver.run(() -> list().requestFocus());
        driver.type(KeyCode.ENTER);
        assertThat(scene().camera()).isEqualTo(view.camera());

        driver.run(() -> driver.studio.moveCamera(camera -> camera.withYawDegrees(80)));
        driver.run(() -> driver.window.workbench().panel().scrollTo(list()));
        Point2D place = WindowDriver.call(() -> cell(0).localToScreen(20, 5));
        driver.withRobot(robot -> {
            robot.mouseMove(place.getX(), place.getY());
            robot.mousePress(MouseButton.PRIMARY);
            robot.mouseRelease(MouseButton.PRIMARY);
            robot.mousePress(MouseButton.PRIMARY);
            robot.mouseRelease(MouseButton.PRIMARY);
        });
        driver.await(() -> driver.studio.scene().camera().equals(view.camera()));
        assertThat(driver.notice()).isEqualTo("View: View 1");
    }

    @Tag("slow")
    @Test
    void deleteInTheListDeletesAViewAndNoBody() {
        add();
        Scene before = scene();
        driver.run(() -> {
            driver.studio.selection().select(Layout.FIRST_SPHERE);
            list().requestFocus();
        });
        driver.type(KeyCode.DELETE);

        assertThat(names()).isEmpty();
        assertThat(scene().spheres()).isEqualTo(before.spheres());
        assertThat(WindowDriver.call(driver.studio.document().editsProperty()::get)
                        .undoable())
                .contains("delete view");
    }

    @Test
    void updatePutsAViewWhereTheCameraIs() {
        add();
        driver.run(() -> driver.studio.moveCamera(camera -> camera.withYawDegrees(80)));
        press("update");

        assertThat(scene().views().getFirst().camera()).isEqualTo(scene().camera());
    }

    @Tag("slow")
    @Test
    void aNameThatIsTakenIsRefusedWithAWord() {
        add();
        add();
        press("rename");
        typeName("View 1");
        driver.type(KeyCode.ENTER);

        assertThat(driver.notice()).isEqualTo("Another view is called 'View 1'");
        assertThat(focusOwner()).isInstanceOf(TextField.class);
        driver.type(KeyCode.ESCAPE);
        assertThat(names()).containsExactly("View 1", "View 2");
        assertThat(focusOwner()).isInstanceOf(ListView.class);
    }

    @Tag("slow")
    @Test
    void buttonsThatNeedAViewAreOffWithoutOne() {
        assertThat(button("go-to").isDisabled()).isTrue();
        assertThat(button("add").isDisabled()).isFalse();
        add();
        assertThat(button("go-to").isDisabled()).isFalse();
    }

    private CameraView add() {
        press("add");
        driver.type(KeyCode.ENTER);
        return scene().views().getLast();
    }

    private void typeName(String text) {
        TextField field = driver.find("#view-name", TextField.class);
        driver.run(() -> {
            field.selectAll();
            field.replaceSelection(text);
        });
    }

    private void press(String button) {
        driver.run(button(button)::fire);
        driver.pulse();
    }

    private Button button(String name) {
        return driver.find("#view-" + name, Button.class);
    }

    private ListView<?> list() {
        return driver.find("#views", ListView.class);
    }

    private ListCell<?> cell(int index) {
        return driver.stage.getScene().getRoot().lookupAll("#views .list-cell").stream()
                .map(node -> (ListCell<?>) node)
                .filter(cell -> cell.getIndex() == index)
                .findFirst()
                .orElseThrow();
    }

    private String cellText(int index) {
        return WindowDriver.call(() -> cell(index).getText());
    }

    private Node focusOwner() {
        return WindowDriver.call(() -> driver.stage.getScene().getFocusOwner());
    }

    private Scene scene() {
        return WindowDriver.call(driver.studio::scene);
    }

    private List<String> names() {
        return scene().views().stream().map(CameraView::name).toList();
    }
}
