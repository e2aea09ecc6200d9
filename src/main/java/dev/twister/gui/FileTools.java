package dev.twister.gui;

import dev.twister.gui.controls.Dialogs;
import dev.twister.gui.files.AssetActions;
import dev.twister.gui.files.AutosaveKeeper;
import dev.twister.gui.files.FileActions;
import dev.twister.gui.files.FileChoice;
import dev.twister.gui.files.Reading;
import dev.twister.gui.files.SceneGallery;
import dev.twister.gui.files.SceneSaving;
import dev.twister.gui.files.SettingsKeeper;
import dev.twister.gui.picture.PictureActions;
import dev.twister.gui.studio.BackgroundTasks;
import dev.twister.gui.studio.Studio;
import dev.twister.gui.viewer.PictureViewer;
import java.util.function.BooleanSupplier;
import javafx.stage.Stage;

/** What reads and writes the files of a window: scenes and what they name, pictures, settings and autosaves. */
record FileTools(
        SettingsKeeper settings,
        Dialogs dialogs,
        SceneSaving saving,
        AssetActions assets,
        FileActions files,
        SceneGallery gallery,
        AutosaveKeeper autosaves,
        PictureActions pictures,
        PictureViewer viewer) {
    /** @param takeTyped takes what was typed but not entered, before a scene is saved; see {@link SceneSaving} */
    static FileTools of(
            Stage stage,
            Studio studio,
            MainWindow.Options options,
            Reading reading,
            BackgroundTasks tasks,
            BooleanSupplier takeTyped) {
        SettingsKeeper settings = new SettingsKeeper(options.settings(), options.found(), tasks, studio::notice);
        Dialogs dialogs = new Dialogs(stage);
        FileChoice choice = options.files();
        SceneSaving saving = new SceneSaving(studio, choice, options.shipped(), dialogs, settings, tasks, takeTyped);
        AssetActions assets = new AssetActions(studio, choice, dialogs, settings, reading);
        FileActions files =
                new FileActions(studio, choice, options.shipped(), dialogs, settings, reading, saving, assets, tasks);
        return new FileTools(
                settings,
                dialogs,
                saving,
                assets,
                files,
                new SceneGallery(stage, settings, files),
                new AutosaveKeeper(studio, options.autosaves()),
                new PictureActions(studio, choice, dialogs, tasks),
                new PictureViewer(stage, studio, choice, dialogs, tasks));
    }
}
