package dev.twister.gui.files;

import dev.twister.gui.model.SettingsStore;
import dev.twister.gui.model.WindowSettings;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import java.util.function.UnaryOperator;
import javafx.beans.property.ReadOnlyObjectProperty;
import javafx.beans.property.ReadOnlyObjectWrapper;

/**
 * The present settings. They are written when the window closes and when a scene is opened or saved. Only the changes
 * of this window are applied to the file, because another window may have written it.
 */
public final class SettingsKeeper {
    private final SettingsStore store;
    private final Consumer<String> complain;
    private final ReadOnlyObjectWrapper<WindowSettings> settings;

    /** Changes since the settings were last written. */
    private final List<UnaryOperator<WindowSettings>> changes = new ArrayList<>();

    /** @param complain takes messages for the status line */
    public SettingsKeeper(SettingsStore store, SettingsStore.Found found, Consumer<String> complain) {
        this.store = store;
        this.complain = complain;
        settings = new ReadOnlyObjectWrapper<>(found.settings());
        found.message().ifPresent(complain);
    }

    public ReadOnlyObjectProperty<WindowSettings> settingsProperty() {
        return settings.getReadOnlyProperty();
    }

    public WindowSettings settings() {
        return settings.get();
    }

    public void change(UnaryOperator<WindowSettings> change) {
        settings.set(change.apply(settings.get()));
        changes.add(change);
    }

    /** Puts a file that was opened or saved first in the menu of recent scenes. */
    public void remember(Path file) {
        change(kept -> kept.withRecentScene(FileNames.absolute(file).toString()));
        write();
    }

    /** Takes a file that no longer exists out of the menu of recent scenes. */
    void forgetIfGone(Path file) {
        if (!Files.exists(file)) {
            change(kept -> kept.withoutRecentScene(FileNames.absolute(file).toString()));
        }
    }

    /** Writes the settings on this thread: they have a few hundred bytes. */
    public void write() {
        try {
            SettingsStore.Found found = store.read();
            found.message().ifPresent(complain);
            WindowSettings kept = found.settings();
            for (UnaryOperator<WindowSettings> change : changes) {
                kept = change.apply(kept);
            }
            store.write(kept);
            changes.clear();
        } catch (IOException problem) {
            complain.accept("The window's settings are not kept: " + problem.getMessage());
        }
    }
}
