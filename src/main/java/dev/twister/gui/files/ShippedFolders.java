package dev.twister.gui.files;

import dev.twister.files.WholeFile;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;

/**
 * The folders of shipped files, to which the window does not write. They need not exist.
 *
 * @param scenes shipped scenes
 * @param skyboxes shipped panoramas
 */
public record ShippedFolders(Path scenes, Path skyboxes) {
    /**
     * The shipped scenes, by name.
     *
     * @throws IOException if their folder cannot be read
     */
    List<Path> list() throws IOException {
        try (Stream<Path> files = Files.list(scenes)) {
            return files.filter(file -> DroppedFile.kind(file) == DroppedFile.Kind.SCENE)
                    .sorted()
                    .toList();
        }
    }

    /** The shipped panoramas as absolute paths, by name; none if their folder cannot be read. */
    public List<Path> skies() {
        try (Stream<Path> files = Files.list(skyboxes)) {
            return files.filter(file -> DroppedFile.kind(file) == DroppedFile.Kind.SKYBOX)
                    .map(FileNames::absolute)
                    .sorted()
                    .toList();
        } catch (IOException _) {
            return List.of();
        }
    }

    /** Whether a file, which need not exist, is in the folder of shipped scenes. */
    boolean isScene(Path file) {
        try {
            Path folder = WholeFile.behindLinks(file).getParent();
            return folder != null && Files.isDirectory(scenes) && Files.isSameFile(folder, scenes);
        } catch (IOException _) {
            return false;
        }
    }
}
