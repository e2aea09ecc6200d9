package dev.twister.gui;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import dev.twister.gui.controls.Command;
import dev.twister.gui.drawing.DrawnPicture;
import dev.twister.gui.edit.BodyEdits;
import dev.twister.gui.edit.BodyMaterials;
import dev.twister.gui.edit.BodyNumber;
import dev.twister.gui.edit.BodyTitles;
import dev.twister.gui.edit.MaterialPreset;
import dev.twister.gui.files.AutosaveFolder;
import dev.twister.gui.files.WindowSettings;
import dev.twister.gui.panel.PanelRow;
import dev.twister.gui.picture.PictureView;
import dev.twister.gui.studio.OpenedScene;
import dev.twister.scene.Geometry;
import dev.twister.scene.Mesh;
import dev.twister.scene.Rotation;
import dev.twister.scene.Scene;
import dev.twister.scene.Shape;
import dev.twister.scene.Vector3;
import dev.twister.scene.format.SceneReader;
import dev.twister.scene.format.SceneWriter;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Optional;
import javafx.geometry.Bounds;
import javafx.geometry.Point2D;
import javafx.scene.control.CheckBox;
import javafx.scene.control.ComboBox;
import javafx.scene.control.Menu;
import javafx.scene.control.MenuBar;
import javafx.scene.control.MenuItem;
import javafx.scene.control.TextField;
import javafx.scene.input.KeyCode;
import javafx.scene.input.MouseButton;
import javafx.scene.shape.Polygon;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Meshes selected, edited and opened by hand. */
class MeshesTest {
    private static final Path VASE =
            Path.of("scenes", "meshes", "vase.obj").toAbsolutePath().normalize();
    private static final int FIRST = BodyNumber.ofMesh(0);
    private static final int SECOND = BodyNumber.ofMesh(1);
    private static WindowDriver driver;

    @TempDir
    private Path folder;

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
        show(scene());
    }

    private static void show(Scene scene) {
        driver.run(() -> {
            driver.studio.show(new OpenedScene(Path.of("test.json"), scene));
            driver.files.chooseNothing();
        });
        awaitMeshes();
    }

    /** Two vases on the plane before the camera. */
    private static Scene scene() {
        Scene tiny = WindowScenes.tiny();
        Mesh vase = Mesh.of(VASE).withSmoothDegrees(40);
        return tiny.withSpheres(tiny.spheres().subList(0, 1))
                .withCamera(tiny.camera()
                        .withPosition(new Vector3(0, 1, -6))
                        .withYawDegrees(0)
                        .withPitchDegrees(0))
                .withMeshes(List.of(vase.withPosition(new Vector3(-1, 0, 0)), vase.withPosition(new Vector3(1, 0, 0))));
    }

    private static DrawnPicture awaitMeshes() {
        driver.await(() -> driver.studio
                .pictureProperty()
                .get()
                .filter(picture -> picture.request().number() >= driver.studio.lastRequest()
                        && picture.isWhole()
                        && picture.request().scene().meshes().stream().allMatch(picture.meshes()::holds))
                .isPresent());
        driver.pulse();
        driver.pulse();
        return WindowDriver.call(() -> driver.studio.pictureProperty().get().orElseThrow());
    }

    private static Scene now() {
        return WindowDriver.call(driver.studio::scene);
    }

    private static Mesh mesh(int body) {
        return BodyEdits.mesh(now(), body);
    }

    private static int selected() {
        return WindowDriver.call(driver.studio.selection()::active);
    }

    private static void select(int body) {
        driver.run(() -> driver.studio.selection().select(body));
        driver.pulse();
    }

    private static void focusPicture() {
        PictureView view = driver.find(".picture", PictureView.class);
        driver.run(view::requestFocus);
    }

    private static PanelRow row(String label) {
        return WindowDriver.call(() -> driver.window.workbench().panel().rows().stream()
                .filter(row -> row.name().equals(label))
                .findFirst()
                .orElseThrow());
    }

    private static List<String> rowNames() {
        return WindowDriver.call(() -> driver.window.workbench().panel().rows().stream()
                .map(PanelRow::name)
                .toList());
    }

    private static void type(String label, String text) {
        TextField field = WindowDriver.call(() -> (TextField) row(label).lookup(".text-field"));
        driver.run(field::requestFocus);
        driver.typeWith(KeyCode.A, KeyCode.CONTROL);
        driver.run(() -> field.replaceSelection(text));
        driver.type(KeyCode.ENTER);
    }

    /** The middle of the outline of the body that is selected, on the screen. */
    private static Point2D outlineMiddle() {
        Bounds bounds = outline();
        return new Point2D(bounds.getCenterX(), bounds.getCenterY());
    }

    private static Bounds outline() {
        Polygon outline = driver.find("#outline", Polygon.class);
        return WindowDriver.call(() -> outline.localToScreen(outline.getLayoutBounds()));
    }

    private static String undoable() {
        return WindowDriver.call(
                () -> driver.studio.document().editsProperty().get().undoable().orElse(""));
    }

    private static void drag(Point2D from, double right) {
        driver.withRobot(hand -> hand.mouseMove(from.getX(), from.getY()));
        driver.withRobot(hand -> hand.mousePress(MouseButton.PRIMARY));
        for (int step = 1; step <= 4; step++) {
            double part = step / 4.0;
            driver.withRobot(hand -> hand.mouseMove(from.getX() + part * right, from.getY()));
        }
        driver.withRobot(hand -> hand.mouseRelease(MouseButton.PRIMARY));
    }

    @Test
    void aClickSelectsAMeshAndTheOutlineLiesOnIt() {
        select(SECOND);
        Point2D second = outlineMiddle();
        select(FIRST);
        Point2D first = outlineMiddle();
        driver.click(second.getX(), second.getY());
        assertThat(selected()).isEqualTo(SECOND);
        driver.click(first.getX(), first.getY());
        assertThat(selected()).isEqualTo(FIRST);
        assertThat(driver.text("selection-hint")).startsWith("Mesh 1 (vase.obj) of 2.");
        Bounds place = outline();
        driver.click(place.getCenterX(), place.getMinY() - 4);
        assertThat(selected()).isNotEqualTo(FIRST);
    }

    @Tag("slow")
    @Test
    void aMeshIsDraggedAndThatIsOneEdit() {
        select(FIRST);
        Point2D start = outlineMiddle();
        Vector3 before = mesh(FIRST).position();
        drag(start, -80);
        awaitMeshes();
        Vector3 after = mesh(FIRST).position();
        assertThat(after.x()).isLessThan(before.x() - 0.2);
        assertThat(after.y()).isCloseTo(before.y(), within(0.02));
        assertThat(outlineMiddle().getX() - start.getX()).isCloseTo(-80, within(8.0));
        assertThat(undoable()).isEqualTo("move");
        driver.run(driver.studio::undo);
        assertThat(now()).isEqualTo(WindowDriver.call(driver.studio.document()::original));
    }

    @Tag("slow")
    @Test
    void itsNumbersAreEditedAndTheirUndoIsNamed() {
        select(SECOND);
        for (String axis : List.of("x", "y", "z", "yaw", "pitch", "roll", "scale")) {
            type("Mesh " + axis, "1.5");
            assertThat(undoable()).isEqualTo("mesh " + axis);
        }
        assertThat(mesh(SECOND).position()).isEqualTo(new Vector3(1.5, 1.5, 1.5));
        assertThat(mesh(SECOND).rotation()).isEqualTo(new Rotation(1.5, 1.5, 1.5));
        assertThat(mesh(SECOND).scale()).isEqualTo(1.5);
        assertThat(mesh(FIRST)).isEqualTo(scene().meshes().getFirst());
        for (int edit = 0; edit < 7; edit++) {
            driver.run(driver.studio::undo);
        }
        assertThat(now()).isEqualTo(scene().withCamera(now().camera()));
    }

    @Tag("slow")
    @Test
    void aMeshIsDuplicatedCopiedPastedAndDeleted() {
        select(FIRST);
        focusPicture();
        driver.typeWith(KeyCode.D, KeyCode.CONTROL);
        assertThat(now().meshes()).hasSize(3);
        assertThat(selected()).isEqualTo(BodyNumber.ofMesh(2));
        assertThat(undoable()).isEqualTo("duplicate mesh");
        Mesh copy = mesh(BodyNumber.ofMesh(2));
        assertThat(copy.withPosition(mesh(FIRST).position())).isEqualTo(mesh(FIRST));
        double apart = copy.position().x() - mesh(FIRST).position().x();
        assertThat(apart).isBetween(0.3, 3.0);

        driver.typeWith(KeyCode.C, KeyCode.CONTROL);
        assertThat(driver.notice()).isEqualTo("Copied a mesh");
        driver.typeWith(KeyCode.V, KeyCode.CONTROL);
        assertThat(now().meshes()).hasSize(4);
        assertThat(undoable()).isEqualTo("paste mesh");
        driver.type(KeyCode.DELETE);
        assertThat(now().meshes()).hasSize(3);
        assertThat(undoable()).isEqualTo("delete mesh");
        assertThat(selected()).isEqualTo(BodyNumber.NONE);
        driver.run(driver.studio::undo);
        assertThat(now().meshes()).hasSize(4);
        // The files are at hand.
        assertThat(awaitMeshes().input().bodies().floats().length).isGreaterThan(0);
    }

    @Test
    void aDeletedSphereLeavesTheMeshSelected() {
        select(SECOND);
        driver.run(() -> driver.studio.edit("delete sphere", scene -> BodyEdits.deleted(scene, 2)));
        assertThat(selected()).isEqualTo(SECOND);
        driver.run(() -> driver.studio.edit("delete mesh", scene -> BodyEdits.deleted(scene, FIRST)));
        assertThat(selected()).isEqualTo(BodyNumber.NONE);
    }

    @Tag("slow")
    @Test
    void aMeshGetsAMaterialOfItsOwnAndTheFilesBack() {
        select(FIRST);
        assertThat(driver.text("material-hint")).isEqualTo("Mesh 1 (vase.obj) has the materials of its file.");
        assertThat(rowNames()).contains("Own material").doesNotContain("Roughness");
        driver.run(() -> ((CheckBox) row("Own material").firstControl()).fire());
        assertThat(undoable()).isEqualTo("own material");
        // As the file has it, so that nothing else changes.
        assertThat(mesh(FIRST).material())
                .contains(WindowDriver.call(() -> driver.studio.bodies().fileMaterial(SECOND)));
        type("Roughness", "0.5");
        assertThat(BodyMaterials.of(now(), FIRST).roughness()).isEqualTo(0.5);
        ComboBox<Optional<MaterialPreset>> box = box("Preset");
        driver.run(() -> box.setValue(Optional.of(MaterialPreset.GLASS)));
        assertThat(BodyMaterials.of(now(), FIRST).transmission()).isEqualTo(1);
        assertThat(mesh(SECOND).material()).isEmpty();
        driver.run(() -> ((CheckBox) row("Own material").firstControl()).fire());
        assertThat(mesh(FIRST).material()).isEmpty();
        assertThat(rowNames()).doesNotContain("Roughness");
        driver.run(driver.studio::undo);
        assertThat(rowNames()).contains("Roughness");
    }

    @SuppressWarnings("unchecked")
    private static <T> ComboBox<T> box(String label) {
        return (ComboBox<T>) row(label).firstControl();
    }

    @Tag("slow")
    @Test
    void theInspectorNamesTheMesh() {
        select(SECOND);
        Point2D middle = outlineMiddle();
        driver.typeWith(KeyCode.I, KeyCode.CONTROL);
        driver.withRobot(hand -> hand.mouseMove(middle.getX(), middle.getY()));
        driver.await(() -> driver.text("inspector-text").contains("mesh 2, "));
        driver.typeWith(KeyCode.I, KeyCode.CONTROL);
    }

    @Test
    void theSelectedMeshIsFramed() {
        select(SECOND);
        focusPicture();
        driver.type(Command.FRAME.keys());
        awaitMeshes();
        Bounds picture = driver.pictureOnScreen();
        assertThat(outlineMiddle().getX()).isCloseTo(picture.getCenterX(), within(picture.getWidth() / 20));
        assertThat(outline().getHeight()).isGreaterThan(0.4 * Math.min(picture.getWidth(), picture.getHeight()));
        driver.run(() -> driver.studio.cameraControl().goHome());
    }

    @Tag("slow")
    @Test
    void editsOfMeshesAreAutosavedAndSaved() throws IOException {
        Path autosaves = Files.createDirectory(folder.resolve("autosaves"));
        Path file = folder.resolve("scene.json");
        try (WindowDriver own = WindowDriver.open(
                new OpenedScene(file, scene()), new AutosaveFolder(Optional.of(autosaves), Duration.ZERO))) {
            own.run(() -> own.studio.edit("move", scene -> BodyEdits.moved(scene, FIRST, new Vector3(3, 0, 0))));
            own.await(() -> autosaved(autosaves).isPresent());
            Scene kept = SceneReader.read(autosaved(autosaves).orElseThrow());
            assertThat(kept.meshes())
                    .isEqualTo(WindowDriver.call(own.studio::scene).meshes());
        }
    }

    private static Optional<Path> autosaved(Path folder) {
        try (var files = Files.list(folder)) {
            return files.filter(file -> file.toString().endsWith(".json")).findFirst();
        } catch (IOException _) {
            return Optional.empty();
        }
    }

    @Tag("slow")
    @Test
    void aMeshThatIsDroppedIsOpenedInASceneOfItsOwn() throws IOException {
        Path mesh = Files.copy(VASE, folder.resolve("pot.obj"));
        driver.run(() -> driver.window.workbench().files().drop(List.of(mesh)));
        driver.await(() -> driver.studio.scene().meshes().stream()
                .anyMatch(shown -> shown.file().equals(Optional.of(mesh))));
        assertThat(WindowDriver.call(driver.stage::getTitle)).isEqualTo("pot.json – Twister");
        DrawnPicture picture = awaitMeshes();
        assertThat(picture.input().bodies().firstMesh()).isPositive();
        assertThat(driver.window.workbench().settings().settings().get(WindowSettings.RECENT_SCENES))
                .contains(mesh.toString());
    }

    @Test
    void aMeshIsInsertedBeforeTheCamera() {
        driver.files.choose(VASE.resolveSibling("vase.ply"));
        focusPicture();
        driver.typeWith(KeyCode.INSERT, KeyCode.SHIFT);
        driver.await(() -> now().meshes().size() == 3);
        assertThat(selected()).isEqualTo(BodyNumber.ofMesh(2));
        assertThat(undoable()).isEqualTo("insert mesh");
        awaitMeshes();
        Bounds picture = driver.pictureOnScreen();
        assertThat(picture.contains(outlineMiddle())).isTrue();
        driver.run(driver.studio::undo);
        assertThat(now().meshes()).hasSize(2);
    }

    @Test
    void aShapeIsInsertedOnThePlane() {
        driver.run(() -> addMenu().getItems().stream()
                .filter(item -> "menu-insert-torus".equals(item.getId()))
                .forEach(MenuItem::fire));
        awaitMeshes();
        assertThat(selected()).isEqualTo(BodyNumber.ofMesh(2));
        assertThat(undoable()).isEqualTo("insert torus");
        Mesh ring = now().meshes().getLast();
        assertThat(BodyTitles.title(now(), selected())).isEqualTo("Mesh 3 (torus)");
        assertThat(ring.position().y() - ((Shape) ring.geometry()).size().y() / 2)
                .isGreaterThanOrEqualTo(now().ground().height());
        driver.run(driver.studio::undo);
        assertThat(now().meshes()).hasSize(2);
    }

    private static Menu addMenu() {
        return ((MenuBar) driver.stage.getScene().lookup(".menu-bar"))
                .getMenus().stream()
                        .filter(menu -> menu.getText().replace("_", "").equals("Add"))
                        .findFirst()
                        .orElseThrow();
    }

    @Tag("slow")
    @Test
    void aSceneWithAMeshThatIsBrokenIsShownWithoutIt() throws IOException {
        Path broken = Files.writeString(folder.resolve("broken.obj"), "v 0 0 0\n");
        Scene scene = scene();
        Path file = folder.resolve("scene.json");
        SceneWriter.write(
                scene.withMeshes(List.of(
                        scene.meshes().getFirst().withGeometry(new Geometry.OfFile(broken)),
                        scene.meshes().getLast())),
                file);
        driver.run(() -> driver.window.workbench().files().open(file));
        driver.await(() -> driver.text("message").equals(broken + ": holds no triangles"));
        driver.await(() -> driver.studio
                .pictureProperty()
                .get()
                .orElseThrow()
                .meshes()
                .holds(scene.meshes().getLast()));
        select(SECOND);
        Point2D middle = outlineMiddle();
        select(BodyNumber.NONE);
        driver.click(middle.getX(), middle.getY());
        assertThat(selected()).isEqualTo(SECOND);
        driver.run(() -> driver.studio.edit("delete mesh", now -> BodyEdits.deleted(now, FIRST)));
        driver.await(() -> driver.text("message").isEmpty());
    }
}
