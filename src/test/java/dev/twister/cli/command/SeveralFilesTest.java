package dev.twister.cli.command;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import dev.twister.cli.file.BadInputException;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class SeveralFilesTest {
    @TempDir
    private Path folder;

    @Test
    void theMeshesOfAFolderInTheAlphabetsOrder() throws IOException {
        touch("b.obj", "a.GLB", "a.json", "notes.txt");

        assertThat(SeveralFiles.of(folder.toString()))
                .contains(List.of(folder.resolve("a.GLB"), folder.resolve("b.obj")));
    }

    @Test
    void theFilesOfAPattern() throws IOException {
        touch("b.obj", "a.obj", "a.stl");

        assertThat(SeveralFiles.of(folder + "/*.obj"))
                .contains(List.of(folder.resolve("a.obj"), folder.resolve("b.obj")));
    }

    @Test
    void hiddenFilesAreLeftOut() throws IOException {
        touch("a.obj", "._a.obj", ".b.obj");

        assertThat(SeveralFiles.of(folder.toString())).contains(List.of(folder.resolve("a.obj")));
        assertThat(SeveralFiles.of(folder + "/*.obj")).contains(List.of(folder.resolve("a.obj")));
        assertThat(SeveralFiles.of(folder + "/.b*")).contains(List.of(folder.resolve(".b.obj")));
    }

    @Test
    void patternsOfSeveralFoldersAreRefused() {
        for (String pattern : List.of("/**/*.obj", "/**.obj", "/nowhere/*.obj")) {
            assertThatThrownBy(() -> SeveralFiles.of(folder + pattern))
                    .isInstanceOf(BadInputException.class)
                    .hasMessageContaining("is not a pattern of files of one folder");
        }
    }

    @Test
    void oneFileIsNotSeveral() throws IOException {
        touch("a[1].obj");

        assertThat(SeveralFiles.of(folder + "/a[1].obj")).isEmpty();
        assertThat(SeveralFiles.of("benchmark")).isEmpty();
    }

    @Test
    void saysWhereThereIsNone() {
        assertThatThrownBy(() -> SeveralFiles.of(folder.toString()))
                .isInstanceOf(BadInputException.class)
                .hasMessage("there is no mesh file in the folder " + folder);
        assertThatThrownBy(() -> SeveralFiles.of(folder + "/*.glb")).hasMessage("no file matches " + folder + "/*.glb");
        assertThatThrownBy(() -> SeveralFiles.of(folder + "/[a")).hasMessageContaining("'[a' is not a pattern");
    }

    @Test
    void picturesHaveDifferentNames() {
        assertThat(SeveralFiles.pictures(List.of(Path.of("a.obj"), Path.of("A.stl"), Path.of("b.c.glb"))))
                .containsExactly("a.obj.png", "A.stl.png", "b.c.png");
    }

    private void touch(String... names) throws IOException {
        for (String name : names) {
            Files.createFile(folder.resolve(name));
        }
    }
}
