package dev.twister.gui;

import static org.assertj.core.api.Assertions.assertThat;

import dev.twister.gui.files.AutosaveFolder;
import dev.twister.gui.files.SettingsStore;
import dev.twister.gui.files.WindowSettings;
import dev.twister.gui.studio.OpenedScene;
import dev.twister.kernel.Layout;
import dev.twister.scene.format.SceneReader;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Optional;
import javafx.scene.control.Button;
import javafx.scene.input.KeyCode;
import javax.imageio.ImageIO;
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
                .extracting(
                        event -> Path.of(event.getString("path")).getFileName().toString())
                .contains("other.json", "texture.png", "sky.hdr");
        assertThat(here)
                .noneMatch(event ->
                        event.getThread() != null && FX.equals(event.getThread().getJavaName()));
    }

    private void openEditAndSave(Path other) throws IOException {
        Path start = folder.resolve("start.json");
        copy(start);
        AutosaveFolder autosaves =
                new AutosaveFolder(Optional.of(Files.createDirectory(folder.resolve("autosaves"))), Duration.ZERO);
        SettingsStore settings = new SettingsStore(Optional.of(folder.resolve("settings")));
        WindowDriver driver = WindowDriver.open(new OpenedScene(start, SceneReader.read(start)), settings, autosaves);
        try {
            driver.run(() -> driver.window.workbench().files().drop(List.of(other)));
            driver.await(() -> driver.studio.document().file().equals(other));
            driver.run(() -> driver.studio.edit(
                    "shadows", scene -> scene.withRendering(scene.rendering().withShadowSamples(1))));
            driver.typeWith(KeyCode.S, KeyCode.CONTROL);
            driver.await(() -> !driver.studio.document().editsProperty().get().changed());
            saveAndRecordPictures(driver);
            chooseTextureAndSky(driver);
        } finally {
            driver.close();
        }
        assertThat(settings.read().settings().get(WindowSettings.RECENT_SCENES)).contains(other.toString());
    }

    private void saveAndRecordPictures(WindowDriver driver) throws IOException {
        Path picture = folder.resolve("picture.png");
        driver.files.choose(picture);
        driver.type(KeyCode.F12);
        driver.await(() -> Files.exists(picture));
        Path frames = Files.createDirectory(folder.resolve("frames"));
        driver.files.choose(frames);
        driver.typeWith(KeyCode.R, KeyCode.CONTROL);
        driver.await(() -> Files.exists(frames.resolve("frame-000001.png")));
        driver.typeWith(KeyCode.R, KeyCode.CONTROL);
    }

    private void chooseTextureAndSky(WindowDriver driver) throws IOException {
        Path texture = folder.resolve("texture.png");
        ImageIO.write(new BufferedImage(2, 2, BufferedImage.TYPE_INT_RGB), "png", texture.toFile());
        driver.run(() -> driver.studio.selection().select(Layout.FIRST_SPHERE));
        driver.files.choose(texture);
        driver.run(() -> driver.find("#other-texture", Button.class).fire());
        driver.await(() ->
                driver.studio.scene().spheres().getFirst().material().texture().isPresent());
        Path sky = Files.copy(Path.of("skyboxes", "gradient.hdr"), folder.resolve("sky.hdr"));
        driver.run(() -> driver.window.workbench().files().drop(List.of(sky)));
        driver.await(() -> driver.studio.scene().sky().file().equals(sky));
        driver.awaitCurrentPicture();
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
