package dev.twister.gui.files;

import static org.assertj.core.api.Assertions.assertThat;

import dev.twister.gui.files.DroppedFile.Kind;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class DroppedFileTest {
    @TempDir
    private Path folder;

    @ParameterizedTest
    @CsvSource({
        "a.json, x, SCENE",
        "A.JSON, x, SCENE",
        "sky.hdr, x, SKYBOX",
        "sky.JPEG, x, SKYBOX",
        "scene.txt, '  {', SCENE",
        "picture.png, '{', SCENE",
        "room 1.2, '{', SCENE",
        "knot.gltf, '{', MESH",
        "photo.json, '\u0089PNG', SKYBOX",
        "sky, '#?RADIANCE', SKYBOX",
        "sky.bin, '\u0089PNG', SKYBOX",
        "photo, '\u00ff\u00d8', SKYBOX",
        "knot.obj, x, MESH",
        "KNOT.GLB, x, MESH",
        "scan, 'ply\n', MESH",
        "model, 'glTF', MESH",
        "notes.txt, hello, OTHER",
        "empty, '', OTHER"
    })
    void isToldByFirstBytesOrName(String name, String start, Kind kind) throws IOException {
        Path file = Files.write(folder.resolve(name), start.getBytes(StandardCharsets.ISO_8859_1));
        assertThat(DroppedFile.kind(file)).isEqualTo(kind);
    }

    @Test
    void aFolderIsNoneOfThem() throws IOException {
        Path scene = Files.createDirectory(folder.resolve("scene.json"));
        assertThat(DroppedFile.kind(scene)).isEqualTo(Kind.OTHER);
        assertThat(DroppedFile.complaint(scene)).startsWith(scene + ": is a folder");
    }

    @Test
    void whatIsGoneIsWhatItsNameSays() {
        assertThat(DroppedFile.kind(folder.resolve("gone.json"))).isEqualTo(Kind.SCENE);
        assertThat(DroppedFile.kind(folder.resolve("gone.hdr"))).isEqualTo(Kind.SKYBOX);
        Path gone = folder.resolve("gone");
        assertThat(DroppedFile.kind(gone)).isEqualTo(Kind.OTHER);
        assertThat(DroppedFile.complaint(gone)).isEqualTo(gone + ": file not found");
    }

    @Test
    void picturesGetAnEndingAndAFreeName() throws IOException {
        assertThat(FileNames.withEnding(folder.resolve("a"))).isEqualTo(folder.resolve("a.png"));
        assertThat(FileNames.withEnding(folder.resolve("a.HDR"))).isEqualTo(folder.resolve("a.HDR"));
        assertThat(FileNames.isLinear(folder.resolve("a.HDR"))).isTrue();
        assertThat(FileNames.freeName(folder)).isEqualTo("twister-1.png");
        Files.createFile(folder.resolve("twister-1.hdr"));
        assertThat(FileNames.freeName(folder)).isEqualTo("twister-2.png");
    }
}
