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
 * The settings that last, as they are now; written when the window closes, and whenever a scene was opened or saved.
 * Another window of this user may have written its own meanwhile: what was changed here is changed in those.
 */
public final class SettingsKeeper {
    private final SettingsStore store;
    private final Consumer<String> complain;
    private final ReadOnlyObjectWrapper<WindowSettings> settings;

    /** Since they were written last. */
    private final List<UnaryOperator<WindowSettings>> changes = new ArrayList<>();

    /**
     * Keeps what was found.
     *
     * @param complain takes a message for the person
     */
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

    /** A few hundred bytes, written whole. */
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
