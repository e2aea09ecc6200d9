package dev.twister.gui;

import dev.twister.gui.files.AutosaveFolder;
import dev.twister.gui.files.FileChoice;
import dev.twister.gui.files.SettingsStore;
import dev.twister.gui.files.ShippedFolders;
import java.nio.file.Path;
import java.util.Optional;

/**
 * The dependencies of a window.
 *
 * @param files the file dialogs
 * @param settings the store of the window's settings
 * @param found the settings read from the store
 * @param autosaves the store of unsaved edits
 * @param shipped the scenes that are offered and never overwritten
 * @param asked the scene's file, if the user named it
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
