package dev.twister.gui;

import static org.assertj.core.api.Assertions.assertThat;

import dev.twister.gui.drawing.DrawnPicture;
import dev.twister.gui.edit.BodyMaterials;
import dev.twister.gui.edit.BodyNumber;
import dev.twister.gui.edit.MaterialPreset;
import dev.twister.gui.edit.TagEdits;
import dev.twister.gui.files.AutosaveFolder;
import dev.twister.gui.panel.PanelRow;
import dev.twister.gui.studio.OpenedScene;
import dev.twister.image.PngWriter;
import dev.twister.kernel.Layout;
import dev.twister.scene.Material;
import dev.twister.scene.Scene;
import dev.twister.scene.Sphere;
import dev.twister.scene.format.SceneReader;
import dev.twister.world.Bodies;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Optional;
import java.util.SequencedMap;
import java.util.stream.IntStream;
import javafx.scene.control.Button;
import javafx.scene.control.CheckBox;
import javafx.scene.control.ComboBox;
import javafx.scene.control.DialogPane;
import javafx.scene.control.Label;
import javafx.scene.control.TextField;
import javafx.scene.input.KeyCode;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Materials edited by hand. */
class MaterialTest {
    private static final int FIRST = Layout.FIRST_SPHERE;
    private static final Material STEEL = Material.DEFAULT.withReflectivity(64);
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

    /** The first two spheres share steel. */
    @BeforeEach
    void startAnew() {
        driver.run(() -> {
            driver.studio.show(new OpenedScene(Path.of("test.json"), scene()));
            driver.files.chooseNothing();
        });
        driver.awaitCurrentPicture();
    }

    private static Scene scene() {
        SequencedMap<String, Material> materials = new LinkedHashMap<>();
        materials.put("steel", STEEL);
        Scene tiny = WindowScenes.tiny();
        List<Sphere> spheres = IntStream.range(0, tiny.spheres().size())
                .mapToObj(i -> i < 2
                        ? tiny.spheres().get(i).withMaterial(STEEL)
                        : tiny.spheres().get(i))
                .toList();
        return tiny.withMaterials(materials).withSpheres(spheres);
    }

    private static Scene now() {
        return WindowDriver.call(driver.studio::scene);
    }

    private static Material material(int body) {
        return BodyMaterials.of(now(), body);
    }

    private static void select(int body) {
        driver.run(() -> driver.studio.selection().select(body));
        driver.pulse();
    }

    private static PanelRow row(String label) {
        return WindowDriver.call(() -> driver.window.workbench().panel().rows().stream()
                .filter(row -> row.name().equals(label))
                .findFirst()
                .orElseThrow());
    }

    @SuppressWarnings("unchecked")
    private static <T> ComboBox<T> box(String label) {
        return (ComboBox<T>) row(label).firstControl();
    }

    private static String unit() {
        driver.pulse();
        Label unit = WindowDriver.call(() -> (Label) row("Reflectivity").lookup(".text-unit"));
        // It is seen whole.
        assertThat(WindowDriver.call(unit::getWidth))
                .isGreaterThanOrEqualTo(WindowDriver.call(() -> unit.prefWidth(-1)));
        return WindowDriver.call(unit::getText);
    }

    private static void type(String label, String text) {
        TextField field = WindowDriver.call(() -> (TextField) row(label).lookup(".text-field"));
        driver.run(field::requestFocus);
        driver.typeWith(KeyCode.A, KeyCode.CONTROL);
        driver.run(() -> field.replaceSelection(text));
        driver.type(KeyCode.ENTER);
    }

    @Test
    void aPresetIsOneEditAndTheRowsShowIt() {
        select(FIRST + 2);
        Scene before = now();
        ComboBox<Optional<MaterialPreset>> box = box("Preset");
        driver.run(() -> box.setValue(Optional.of(MaterialPreset.DIAMOND)));

        assertThat(material(FIRST + 2).ior()).isEqualTo(2.42);
        assertThat(unit()).isEqualTo("% (p 0)");
        assertThat(WindowDriver.call(box::getValue)).contains(MaterialPreset.DIAMOND);
        driver.run(driver.studio::undo);
        assertThat(now()).isEqualTo(before);
        driver.run(driver.studio::redo);
        assertThat(material(FIRST + 2).transmission()).isEqualTo(1);
        driver.awaitCurrentPicture();
    }

    @Test
    void anEditChangesTheSelectedBodyAloneUnlessAllAreToChange() {
        select(FIRST);
        assertThat(driver.text("material-hint")).isEqualTo("Sphere 1 has the material \"steel\", shared by 2 bodies.");
        type("Roughness", "0.5");
        assertThat(material(FIRST)).isEqualTo(STEEL.withRoughness(0.5));
        assertThat(material(FIRST + 1)).isEqualTo(STEEL);
        assertThat(driver.text("material-hint")).isEqualTo("Sphere 1 has a material of its own.");
        assertThat(WindowDriver.call(() -> row("Change all").isDisabled())).isTrue();
        driver.run(driver.studio::undo);

        driver.run(() -> ((CheckBox) row("Change all").firstControl()).fire());
        type("Roughness", "0.5");
        assertThat(material(FIRST)).isEqualTo(STEEL.withRoughness(0.5));
        assertThat(material(FIRST + 1)).isEqualTo(STEEL.withRoughness(0.5));
        assertThat(now().materials()).containsEntry("steel", STEEL.withRoughness(0.5));
        driver.run(driver.studio::undo);
        assertThat(now()).isEqualTo(scene().withCamera(now().camera()));
    }

    @Test
    void theHintFollowsTheBodysName() {
        select(FIRST);
        driver.run(() -> driver.studio.edit(
                "name", scene -> TagEdits.edited(scene, List.of(FIRST), tag -> tag.withName("Ball"))));
        assertThat(driver.text("material-hint")).startsWith("Ball has the material");
    }

    @Test
    void thePlaneHasAMaterialAndTwoColors() {
        select(Layout.PLANE);
        type("Reflectivity", "50");
        assertThat(now().ground().reflectivity()).isEqualTo(64);
        assertThat(unit()).isEqualTo("% (p 64)");
        assertThat(row("First color")).isNotNull();
        assertThat(row("Second color")).isNotNull();
        select(BodyNumber.LIGHT);
        assertThat(WindowDriver.call(() -> driver.window.workbench().panel().rows().stream()
                        .map(PanelRow::name)
                        .toList()))
                .doesNotContain("Reflectivity");
    }

    @Test
    void aTextureIsChosenAndCleared() throws IOException {
        Path red = folder.resolve("red.png");
        PngWriter.write(red, 1, 1, new int[] {0xff0000}, true);
        select(FIRST);
        driver.files.choose(red);
        driver.run(() -> driver.find("#other-texture", Button.class).fire());
        driver.await(() -> material(FIRST).texture().isPresent());

        assertThat(material(FIRST).texture()).contains(red);
        assertThat(material(FIRST + 1).texture()).isEmpty();
        DrawnPicture picture = driver.awaitCurrentPicture();
        Bodies bodies = picture.input().bodies();
        // Behind the maps is the table of lights, of which there is one.
        assertThat(bodies.looks()).hasSize(bodies.textures() + Layout.MAPS_STRIDE + 1);
        ComboBox<Optional<Path>> box = box("Texture");
        assertThat(WindowDriver.call(box::getValue)).contains(red);
        driver.run(() -> box.setValue(Optional.empty()));
        assertThat(material(FIRST).texture()).isEmpty();
        driver.run(driver.studio::undo);
        assertThat(material(FIRST).texture()).contains(red);
    }

    @Test
    void aTextureThatCannotBeReadIsToldAndNotUsed() throws IOException {
        Path bad = Files.writeString(folder.resolve("bad.png"), "no picture");
        select(FIRST);
        for (Path file : List.of(bad, folder.resolve("missing.png"))) {
            driver.files.choose(file);
            driver.run(() -> driver.find("#other-texture", Button.class).fire());
            DialogPane complaint = driver.awaitDialog("complaint");
            assertThat(complaint.getHeaderText()).isEqualTo("Couldn't load the texture");
            assertThat(complaint.getContentText()).startsWith(file + ": ");
            driver.answer(complaint, "OK");
            assertThat(now()).isEqualTo(scene().withCamera(now().camera()));
        }
    }

    @Test
    void anUnsavedMaterialIsAutosaved() throws IOException {
        Path autosaves = Files.createDirectory(folder.resolve("autosaves"));
        Path file = folder.resolve("scene.json");
        OpenedScene opened = new OpenedScene(file, scene());
        try (WindowDriver own = WindowDriver.open(opened, new AutosaveFolder(Optional.of(autosaves), Duration.ZERO))) {
            own.run(() -> own.studio.edit(
                    "preset", scene -> BodyMaterials.edited(scene, FIRST, MaterialPreset.GLASS::appliedTo)));
            own.await(() -> autosaved(autosaves).isPresent());
            Scene kept = SceneReader.read(autosaved(autosaves).orElseThrow());
            assertThat(MaterialPreset.of(BodyMaterials.of(kept, FIRST))).contains(MaterialPreset.GLASS);
            assertThat(BodyMaterials.of(kept, FIRST + 1)).isEqualTo(STEEL);
        }
    }

    private static Optional<Path> autosaved(Path folder) {
        try (var files = Files.list(folder)) {
            return files.filter(file -> file.toString().endsWith(".json")).findFirst();
        } catch (IOException _) {
            return Optional.empty();
        }
    }
}
