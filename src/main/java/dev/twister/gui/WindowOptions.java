package dev.twister.gui;

import dev.twister.gui.files.FileChoice;
import dev.twister.gui.files.ShippedFolders;
import dev.twister.gui.model.AutosaveFolder;
import dev.twister.gui.model.SettingsStore;
import java.nio.file.Path;
import java.util.Optional;

/**
 * What a window needs from outside.
 *
 * @param files asks for files
 * @param settings where the window's settings are kept
 * @param found what was kept there
 * @param autosaves where unsaved edits are kept
 * @param shipped what is offered and not written to
 * @param asked the scene's file, where it was asked for by name
 * @param textScale how much larger than usual text is, above 0
 */
record WindowOptions(
        FileChoice files,
        SettingsStore settings,
        SettingsStore.Found found,
        AutosaveFolder autosaves,
        ShippedFolders shipped,
        Optional<Path> asked,
        double textScale) {}
