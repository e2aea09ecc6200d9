package dev.twister.gui.files;

import dev.twister.files.InputFile;
import dev.twister.files.UserFolder;
import dev.twister.files.WholeFile;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.Map;
import java.util.Optional;
import tools.jackson.core.JacksonException;
import tools.jackson.core.type.TypeReference;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.SerializationFeature;
import tools.jackson.databind.json.JsonMapper;
import tools.jackson.databind.node.ObjectNode;

/**
 * Keeps the window's settings in a JSON file.
 *
 * @param folder the file's folder, created at the first write; empty if this user has none, and then nothing is kept
 */
public record SettingsStore(Optional<Path> folder) {
    static final String FILE = "window.json";
    static final String DAMAGED_FILE = "window.damaged.json";

    /** Thousands of times what the settings take. */
    private static final int MAX_BYTES = 1 << 22;

    private static final JsonMapper JSON =
            JsonMapper.builder().enable(SerializationFeature.INDENT_OUTPUT).build();

    /**
     * What was found.
     *
     * @param message the message for the user; empty if there is none
     */
    public record Found(WindowSettings settings, Optional<String> message) {}

    public static SettingsStore ofThisUser() {
        return new SettingsStore(UserFolder.SETTINGS.ofThisUser());
    }

    /** Reads the settings; what the file does not say is as in the defaults. A damaged file is set aside, not lost. */
    public Found read() {
        if (folder.isEmpty() || !Files.exists(folder.get().resolve(FILE))) {
            return new Found(WindowSettings.DEFAULT, Optional.empty());
        }
        Path file = folder.get().resolve(FILE);
        try {
            return new Found(parse(file), Optional.empty());
        } catch (IOException | JacksonException | IllegalArgumentException damage) {
            return new Found(WindowSettings.DEFAULT, Optional.of(setAside(file)));
        }
    }

    /**
     * Replaces the settings, whole or not at all.
     *
     * @throws IOException as {@link WholeFile#write}
     */
    public void write(WindowSettings settings) throws IOException {
        if (folder.isEmpty()) {
            return;
        }
        byte[] json = JSON.writeValueAsBytes(settings.values());
        Files.createDirectories(folder.get());
        WholeFile.write(folder.get().resolve(FILE), out -> {
            out.write(json);
            out.write('\n');
        });
    }

    private static WindowSettings parse(Path file) throws IOException {
        JsonNode found = JSON.readTree(InputFile.readSmall(file, MAX_BYTES));
        if (!(found instanceof ObjectNode fields)) {
            throw new IOException("not an object");
        }
        return new WindowSettings(JSON.treeToValue(fields, new TypeReference<Map<String, Object>>() {}));
    }

    private static String setAside(Path file) {
        Path aside = file.resolveSibling(DAMAGED_FILE);
        try {
            Files.move(file, aside, StandardCopyOption.REPLACE_EXISTING);
            return "The window's settings could not be read and are as new; the damaged file is kept as " + aside + ".";
        } catch (IOException _) {
            return "The window's settings could not be read and are as new: " + file + " is damaged.";
        }
    }
}
