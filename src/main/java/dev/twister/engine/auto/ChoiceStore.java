package dev.twister.engine.auto;

import dev.twister.files.SmallFile;
import dev.twister.files.UserFolder;
import dev.twister.files.WholeFile;
import java.io.IOException;
import java.io.StringReader;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import java.util.Properties;

/**
 * Remembers the fastest engine, in one file per machine and version. It is a cache: unreadable files count as missing,
 * and if writing fails, engines are measured again.
 *
 * @param folder the folder of the files; empty if this user has none
 */
record ChoiceStore(Optional<Path> folder) {
    private static final String ENGINE = "engine";

    /** Far more than the size of any file that is written. */
    private static final int MOST_BYTES = 1 << 18;

    static ChoiceStore ofThisUser() {
        return new ChoiceStore(UserFolder.CACHE.ofThisUser());
    }

    Optional<String> read(MachineKey key) {
        if (folder.isEmpty()) {
            return Optional.empty();
        }
        Properties properties = new Properties();
        try {
            byte[] bytes = SmallFile.read(folder.get().resolve(key.fileName()), MOST_BYTES);
            properties.load(new StringReader(new String(bytes, StandardCharsets.UTF_8)));
        } catch (IOException | IllegalArgumentException _) {
            return Optional.empty();
        }
        boolean same = key.facts().entrySet().stream()
                .allMatch(fact -> fact.getValue().equals(properties.getProperty(fact.getKey())));
        return same ? Optional.ofNullable(properties.getProperty(ENGINE)) : Optional.empty();
    }

    void write(MachineKey key, String engine) {
        if (folder.isEmpty()
                || isDevice(folder.get().resolve(key.fileName()))
                || read(key).equals(Optional.of(engine))) {
            return;
        }
        Properties properties = new Properties();
        properties.putAll(key.facts());
        properties.setProperty(ENGINE, engine);
        try {
            Files.createDirectories(folder.get());
            WholeFile.write(
                    folder.get().resolve(key.fileName()),
                    out -> properties.store(out, "The fastest engine here, measured by Twister; safe to delete."));
        } catch (IOException _) {
            // The next start measures again.
        }
    }

    // Opening a pipe without a reader blocks.
    private static boolean isDevice(Path file) {
        return Files.exists(file) && !Files.isRegularFile(file);
    }
}
