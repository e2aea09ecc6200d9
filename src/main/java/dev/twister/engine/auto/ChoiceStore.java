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
 * Remembers which engine was the fastest, in a file for each machine and version. It is a cache: what cannot be read is
 * not there, and what cannot be written is measured again.
 *
 * @param folder where the files are; empty where this user has no such place
 */
record ChoiceStore(Optional<Path> folder) {
    private static final String ENGINE = "engine";

    /** Hundreds of times what is written. */
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

    // A pipe without a reader would be waited for.
    private static boolean isDevice(Path file) {
        return Files.exists(file) && !Files.isRegularFile(file);
    }
}
