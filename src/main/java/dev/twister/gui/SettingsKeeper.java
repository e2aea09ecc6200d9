package dev.twister.gui;

import dev.twister.gui.model.SettingsStore;
import dev.twister.gui.model.WindowSettings;
import java.io.IOException;
import java.util.function.Consumer;
import java.util.function.UnaryOperator;
import javafx.beans.property.ReadOnlyObjectProperty;
import javafx.beans.property.ReadOnlyObjectWrapper;

/** The settings that last, as they are now; written when the window closes, and whenever a scene was opened or saved. */
final class SettingsKeeper {
    private final SettingsStore store;
    private final Consumer<String> complain;
    private final ReadOnlyObjectWrapper<WindowSettings> settings;

    /**
     * Keeps what was found.
     *
     * @param complain takes a message for the person
     */
    SettingsKeeper(SettingsStore store, SettingsStore.Found found, Consumer<String> complain) {
        this.store = store;
        this.complain = complain;
        settings = new ReadOnlyObjectWrapper<>(found.settings());
        found.message().ifPresent(complain);
    }

    ReadOnlyObjectProperty<WindowSettings> settingsProperty() {
        return settings.getReadOnlyProperty();
    }

    WindowSettings settings() {
        return settings.get();
    }

    void change(UnaryOperator<WindowSettings> change) {
        settings.set(change.apply(settings.get()));
    }

    /** A few hundred bytes, written whole. */
    void write() {
        try {
            store.write(settings.get());
        } catch (IOException problem) {
            complain.accept("The window's settings are not kept: " + problem.getMessage());
        }
    }
}
