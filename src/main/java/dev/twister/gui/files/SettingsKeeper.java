package dev.twister.gui.files;

import dev.twister.gui.studio.BackgroundTasks;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
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
    private final BackgroundTasks tasks;
    private final Consumer<String> complain;
    private final ReadOnlyObjectWrapper<WindowSettings> settings;

    /** Changes since the settings were last written. */
    private final List<UnaryOperator<WindowSettings>> changes = new ArrayList<>();

    /**
     * The settings that were found.
     *
     * @param tasks read and write the file
     * @param complain takes messages for the status line
     */
    public SettingsKeeper(
            SettingsStore store, SettingsStore.Found found, BackgroundTasks tasks, Consumer<String> complain) {
        this.store = store;
        this.tasks = tasks;
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
        tasks.run(
                () -> Files.exists(file),
                isThere -> {
                    if (!isThere) {
                        change(kept ->
                                kept.withoutRecentScene(FileNames.absolute(file).toString()));
                    }
                },
                _ -> {});
    }

    /** Writes the changes in the background; closing the window waits for it. */
    public void write() {
        List<UnaryOperator<WindowSettings>> written = List.copyOf(changes);
        changes.clear();
        tasks.keepFile(() -> write(written), message -> message.ifPresent(complain), problem -> {
            changes.addAll(0, written);
            complain.accept("The window's settings are not kept: " + problem.getMessage());
        });
    }

    private Optional<String> write(List<UnaryOperator<WindowSettings>> written) throws IOException {
        SettingsStore.Found found = store.read();
        WindowSettings kept = found.settings();
        for (UnaryOperator<WindowSettings> change : written) {
            kept = change.apply(kept);
        }
        store.write(kept);
        return found.message();
    }
}
