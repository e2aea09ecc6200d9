package dev.twister.gui.files;

import dev.twister.files.WholeFile;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;

/**
 * The folders of shipped files, to which the window does not write. They need not exist.
 *
 * @param scenes shipped scenes
 * @param skyboxes shipped panoramas
 */
public record ShippedFolders(Path scenes, Path skyboxes) {
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
