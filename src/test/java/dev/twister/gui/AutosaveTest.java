package dev.twister.gui;

import static org.assertj.core.api.Assertions.assertThat;

import dev.twister.gui.files.AutosaveFolder;
import dev.twister.gui.files.AutosaveFolder.Autosave;
import dev.twister.gui.studio.EditedFile;
import dev.twister.gui.studio.OpenedScene;
import dev.twister.scene.Scene;
import dev.twister.scene.format.SceneReader;
import dev.twister.scene.format.SceneWriter;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Optional;
import javafx.scene.input.KeyCode;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Edits that outlive a process that is killed. */
class AutosaveTest {
    @TempDir
    private Path parent;

    private Path file;
    private AutosaveFolder folder;
    private final Scene scene = WindowScenes.tiny();
    private final Scene edited = changed(scene);

    @BeforeEach
    void writeTheScene() {
        file = parent.resolve("mine.json");
        SceneWriter.write(scene, file);
        folder = new AutosaveFolder(Optional.of(parent.resolve("autosave")), Duration.ZERO);
    }

    private static Scene changed(Scene scene) {
        return scene.withRendering(
                scene.rendering().withBounces(scene.rendering().bounces() + 1));
    }

    private List<Path> kept() throws IOException {
        if (!Files.exists(parent.resolve("autosave"))) {
            return List.of();
        }
        try (var files = Files.list(parent.resolve("autosave"))) {
            return files.filter(path -> path.toString().endsWith(".json")).toList();
        }
    }

    private boolean keepsSomething() {
        try {
            return !kept().isEmpty();
        } catch (IOException problem) {
            throw new AssertionError(problem);
        }
    }

    private WindowDriver open() {
        return WindowDriver.open(OpenedScene.read(file), folder);
    }

    /** What a killed process leaves. */
    private void leave(Path of) throws IOException {
        try (Autosave autosave = folder.begin(new EditedFile(of, EditedFile.Digest.of(of)))) {
            autosave.write(edited);
        }
    }

    @Test
    void anEditIsKeptUntilItIsSaved() throws IOException {
        try (WindowDriver driver = open()) {
            driver.run(() -> driver.studio.edit("bounces", _ -> edited));
            driver.await(this::keepsSomething);
            assertThat(SceneReader.read(kept().getFirst())).isEqualTo(edited);

            driver.typeWith(KeyCode.S, KeyCode.CONTROL);
            driver.await(() -> !keepsSomething());
            assertThat(SceneReader.read(file)).isEqualTo(edited);
        }
    }

    @Tag("slow")
    @Test
    void anEditThatIsGivenUpIsNotKept() throws IOException {
        try (WindowDriver driver = open()) {
            driver.run(() -> driver.studio.edit("bounces", _ -> edited));
            driver.await(this::keepsSomething);
            driver.typeWith(KeyCode.Z, KeyCode.CONTROL);
            driver.await(() -> !keepsSomething());
            driver.typeWith(KeyCode.Z, KeyCode.CONTROL, KeyCode.SHIFT);
            driver.await(this::keepsSomething);
        }
        assertThat(kept()).isEmpty();
    }

    @Test
    void whatAKilledProcessLeftIsRestoredAsUnsavedEdits() throws IOException {
        leave(file);
        try (WindowDriver driver = open()) {
            driver.answer(driver.awaitDialog("restore-question"), "Restore");
            driver.await(() -> driver.studio.document().editsProperty().get().changed());
            assertThat(WindowDriver.call(driver.studio::scene)).isEqualTo(edited);
            assertThat(WindowDriver.call(driver.stage::getTitle)).isEqualTo("• mine.json – Twister");
            assertThat(keepsSomething()).isTrue();

            driver.typeWith(KeyCode.S, KeyCode.CONTROL);
            driver.await(() -> !keepsSomething());
            assertThat(SceneReader.read(file)).isEqualTo(edited);
        }
    }

    @Tag("slow")
    @Test
    void restoredEditsCanBeTakenBack() throws IOException {
        leave(file);
        try (WindowDriver driver = open()) {
            driver.answer(driver.awaitDialog("restore-question"), "Restore");
            driver.await(() -> driver.studio.document().editsProperty().get().changed());
            driver.typeWith(KeyCode.Z, KeyCode.CONTROL);
            assertThat(WindowDriver.call(driver.studio::scene)).isEqualTo(scene);
            assertThat(WindowDriver.call(driver.studio.document().editsProperty()::get)
                            .changed())
                    .isFalse();
        }
    }

    @Tag("slow")
    @Test
    void editsOfAFileThatIsGoneAreRestoredToo() throws IOException {
        leave(parent.resolve("gone.json"));
        try (WindowDriver driver = open()) {
            driver.answer(driver.awaitDialog("restore-question"), "Restore");
            driver.await(() -> driver.studio.document().editsProperty().get().changed());
            assertThat(WindowDriver.call(driver.studio::scene)).isEqualTo(edited);
            assertThat(WindowDriver.call(driver.stage::getTitle)).isEqualTo("• gone.json – Twister");
        }
    }

    @Tag("slow")
    @Test
    void editsWhoseSkyIsGoneAreRestoredUnderThePresentOne() throws IOException {
        Path sky = Files.copy(Path.of("skyboxes", "sunset.hdr"), parent.resolve("gone.hdr"));
        try (Autosave autosave = folder.begin(new EditedFile(file, EditedFile.Digest.of(file)))) {
            autosave.write(edited.withSky(edited.sky().withFile(sky)));
        }
        Files.delete(sky);
        try (WindowDriver driver = open()) {
            driver.answer(driver.awaitDialog("restore-question"), "Restore");
            driver.await(() -> driver.studio.document().editsProperty().get().changed());
            assertThat(WindowDriver.call(driver.studio::scene)).isEqualTo(edited);
        }
    }

    @Tag("slow")
    @Test
    void whatIsDiscardedIsGoneAndWhatIsLeftForLaterIsNot() throws IOException {
        leave(file);
        leave(file);
        try (WindowDriver driver = open()) {
            driver.answer(driver.awaitDialog("restore-question"), "Discard");
            driver.answer(driver.awaitDialog("restore-question"), "Later");
        }
        assertThat(kept()).hasSize(1);
        assertThat(folder.leftBehind()).hasSize(1);
    }
}
