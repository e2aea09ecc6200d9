package dev.twister.gui.files;

import dev.twister.files.WholeFile;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;

/**
 * What Twister brings along, and the window does not write to. The folders need not exist.
 *
 * @param scenes shipped scenes
 * @param skyboxes panoramas that are offered
 */
public record ShippedFolders(Path scenes, Path skyboxes) {
    /** Whether a file, which need not exist, is or would be in the folder of the shipped scenes. */
    boolean isScene(Path file) {
        try {
            Path folder = WholeFile.behindLinks(file).getParent();
            return folder != null && Files.isDirectory(scenes) && Files.isSameFile(folder, scenes);
        } catch (IOException _) {
            return false;
        }
    }
}
