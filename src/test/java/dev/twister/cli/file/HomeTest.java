package dev.twister.cli.file;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class HomeTest {
    @TempDir
    private Path folder;

    @BeforeEach
    void shipScenes() throws IOException {
        Files.createDirectory(folder.resolve("scenes"));
        Files.createFile(folder.resolve("scenes", "scene.schema.json"));
    }

    @Test
    void namedFolderWins() {
        assertThat(Home.folder(Optional.of("named"), Optional.of(folder.resolve("twister.jar"))))
                .isEqualTo(Path.of("named"));
    }

    @Test
    void jarOfAPackageHasTheScenesBesideIt() {
        assertThat(Home.folder(Optional.empty(), Optional.of(folder.resolve("twister.jar"))))
                .isEqualTo(folder);
    }

    @Test
    void jarOfABuildHasTheScenesAboveIt() {
        assertThat(Home.folder(Optional.empty(), Optional.of(folder.resolve("target", "twister.jar"))))
                .isEqualTo(folder);
    }

    @Test
    void jarWithoutScenesMeansTheCurrentFolder() {
        assertThat(Home.folder(Optional.empty(), Optional.of(folder.getRoot().resolve("twister.jar"))))
                .isEqualTo(Path.of(""));
    }
}
