package dev.twister.gui.files;

import static org.assertj.core.api.Assertions.assertThat;

import dev.twister.ChildJvm;
import dev.twister.gui.files.AutosaveFolder.Autosave;
import dev.twister.gui.studio.EditedFile;
import dev.twister.scene.Scene;
import dev.twister.scene.format.SceneReader;
import java.io.File;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

@Timeout(300)
class AutosaveFolderTest {
    private static final Scene SCENE = SceneReader.read(Path.of("scenes", "teaching.json"));
    private static final EditedFile EDITED = new EditedFile(
            Path.of(File.separatorChar == '/' ? "a\nb.json" : "a b.json").toAbsolutePath(),
            new EditedFile.Digest("12ef"));

    @TempDir
    private Path parent;

    private AutosaveFolder folder() {
        return new AutosaveFolder(Optional.of(parent.resolve("autosave")));
    }

    private List<Path> files() throws IOException {
        try (var files = Files.list(parent.resolve("autosave"))) {
            return files.toList();
        }
    }

    /** Keeps a scene and waits to be killed. */
    static final class EditingMain {
        private EditingMain() {}

        public static void main(String[] arguments) throws IOException {
            AutosaveFolder folder = new AutosaveFolder(Optional.of(Path.of(arguments[0])));
            folder.begin(EDITED).write(SCENE);
            System.out.println("written");
            System.in.read();
        }
    }

    @Test
    void whatAKilledProcessLeavesIsFoundAndWhatALivingOneHasIsNot() throws IOException, InterruptedException {
        Process editing = ChildJvm.start(
                ChildJvm.of(EditingMain.class, parent.resolve("autosave").toString())
                        .redirectError(ProcessBuilder.Redirect.INHERIT));
        try {
            assertThat(editing.inputReader().readLine()).isEqualTo("written");
            assertThat(folder().leftBehind()).isEmpty();
        } finally {
            editing.destroyForcibly().waitFor();
        }
        List<Autosave> found = folder().leftBehind();
        assertThat(found).hasSize(1);
        try (Autosave autosave = found.getFirst()) {
            assertThat(autosave.edited()).isEqualTo(EDITED);
            assertThat(SceneReader.read(autosave.file())).isEqualTo(SCENE);
        }
    }

    @Test
    void whatIsLeftIsOfferedToOneAlone() throws IOException {
        try (Autosave begun = folder().begin(EDITED)) {
            begun.write(SCENE);
        }
        List<Autosave> first = folder().leftBehind();
        assertThat(first).hasSize(1);
        assertThat(folder().leftBehind()).isEmpty();
        first.getFirst().close();
    }

    @Test
    void whatIsDeletedIsGone() throws IOException {
        Autosave begun = folder().begin(EDITED);
        begun.write(SCENE);
        begun.delete();
        assertThat(files()).isEmpty();
    }

    @Test
    void aDamagedOneDoesNotHideTheOthers() throws IOException {
        try (Autosave begun = folder().begin(EDITED)) {
            begun.write(SCENE);
        }
        Path autosave = parent.resolve("autosave");
        Files.writeString(autosave.resolve("damaged.lock"), "no line's end");
        Files.writeString(autosave.resolve("damaged.json"), "{}");
        Files.createDirectory(autosave.resolve("folder.lock"));
        Files.writeString(autosave.resolve("folder.json"), "{}");
        List<Autosave> found = folder().leftBehind();
        assertThat(found).extracting(Autosave::edited).containsExactly(EDITED);
        found.getFirst().close();
    }

    @Test
    void nothingIsFoundWhereThereIsNoFolder() {
        assertThat(folder().leftBehind()).isEmpty();
        assertThat(new AutosaveFolder(Optional.empty()).leftBehind()).isEmpty();
    }
}
