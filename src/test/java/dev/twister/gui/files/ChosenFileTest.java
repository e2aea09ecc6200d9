package dev.twister.gui.files;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class ChosenFileTest {
    @TempDir
    private Path folder;

    @Test
    void anEndingIsAddedWhereThereIsNone() {
        assertThat(FileNames.forScene(folder.resolve("saved"))).isEqualTo(folder.resolve("saved.json"));
        assertThat(FileNames.forScene(folder.resolve("room 1.2"))).isEqualTo(folder.resolve("room 1.2.json"));
        assertThat(FileNames.forScene(folder.resolve("shot.png"))).isEqualTo(folder.resolve("shot.png.json"));
        assertThat(FileNames.forScene(folder.resolve("A.JSON"))).isEqualTo(folder.resolve("A.JSON"));
        assertThat(FileNames.forPicture(folder.resolve("shot"), ".png")).isEqualTo(folder.resolve("shot.png"));
        assertThat(FileNames.forPicture(folder.resolve("shot.png"), ".hdr")).isEqualTo(folder.resolve("shot.hdr"));
        assertThat(FileNames.forPicture(folder.resolve("shot"), ".exr")).isEqualTo(folder.resolve("shot.exr"));
    }

    @Test
    void aFileThatNobodyWasAskedAboutIsNotReplaced() throws IOException {
        Files.createFile(folder.resolve("saved.json"));
        Files.createFile(folder.resolve("saved-2.json"));
        Files.createFile(folder.resolve("shot.hdr"));

        assertThat(FileNames.forScene(folder.resolve("saved"))).isEqualTo(folder.resolve("saved-3.json"));
        assertThat(FileNames.forScene(folder.resolve("saved.json"))).isEqualTo(folder.resolve("saved.json"));
        assertThat(FileNames.forPicture(folder.resolve("shot.png"), ".hdr")).isEqualTo(folder.resolve("shot-2.hdr"));
        assertThat(FileNames.forPicture(folder.resolve("shot.hdr"), ".hdr")).isEqualTo(folder.resolve("shot.hdr"));
    }
}
