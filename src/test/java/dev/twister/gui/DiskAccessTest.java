package dev.twister.gui;

import static org.assertj.core.api.Assertions.assertThat;

import dev.twister.gui.model.AutosaveFolder;
import dev.twister.gui.studio.OpenedScene;
import dev.twister.scene.format.SceneReader;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Optional;
import javafx.scene.input.KeyCode;
import jdk.jfr.Recording;
import jdk.jfr.consumer.RecordedEvent;
import jdk.jfr.consumer.RecordingFile;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** JavaFX's thread never waits for a disk. */
class DiskAccessTest {
    private static final String FX = "JavaFX Application Thread";

    @TempDir
    private Path folder;

    @Test
    void filesAreReadAndWrittenByOtherThreads() throws IOException {
        Path recorded = folder.resolve("record.jfr");
        Path other = folder.resolve("other.json");
        copy(other);
        try (Recording recording = new Recording()) {
            recording.enable("jdk.FileRead").withoutThreshold();
            recording.enable("jdk.FileWrite").withoutThreshold();
            recording.start();
            openEditAndSave(other);
            recording.stop();
            recording.dump(recorded);
        }
        List<RecordedEvent> here = RecordingFile.readAllEvents(recorded).stream()
                .filter(event -> event.hasField("path")
                        && Optional.ofNullable(event.getString("path"))
                                .filter(path ->
                                        path.contains(folder.getFileName().toString()))
                                .isPresent())
                .toList();

        assertThat(here).extracting(event -> event.getEventType().getName()).contains("jdk.FileRead", "jdk.FileWrite");
        assertThat(here)
                .noneMatch(event ->
                        event.getThread() != null && FX.equals(event.getThread().getJavaName()));
    }

    private void openEditAndSave(Path other) throws IOException {
        Path start = folder.resolve("start.json");
        copy(start);
        AutosaveFolder autosaves =
                new AutosaveFolder(Optional.of(Files.createDirectory(folder.resolve("autosaves"))), Duration.ZERO);
        WindowDriver driver = WindowDriver.open(new OpenedScene(start, SceneReader.read(start)), autosaves);
        try {
            driver.run(() -> driver.window.workbench().files().drop(List.of(other)));
            driver.await(() -> driver.studio.document().file().equals(other));
            driver.run(() -> driver.studio.edit(
                    "shadows", scene -> scene.withRendering(scene.rendering().withShadowSamples(1))));
            driver.typeWith(KeyCode.S, KeyCode.CONTROL);
            driver.await(() -> !driver.studio.document().editsProperty().get().changed());
        } finally {
            driver.close();
        }
    }

    private void copy(Path file) throws IOException {
        Files.writeString(
                file,
                Files.readString(Path.of("scenes", "teaching.json"))
                        .replace(
                                "../skyboxes/day.hdr",
                                Path.of("skyboxes", "day.hdr")
                                        .toAbsolutePath()
                                        .toString()
                                        .replace('\\', '/')));
    }
}
