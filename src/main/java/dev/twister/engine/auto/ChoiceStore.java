package dev.twister.engine.auto;

import dev.twister.files.InputFile;
import dev.twister.files.UserFolder;
import dev.twister.files.WholeFile;
import java.io.IOException;
import java.io.StringReader;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Clock;
import java.time.LocalDate;
import java.time.format.DateTimeParseException;
import java.util.Optional;
import java.util.Properties;

/**
 * Remembers the fastest engine and the day of its measurement, in one file per machine and version. It is a cache:
 * unreadable and old files count as missing, and if writing fails, engines are measured again.
 *
 * @param folder the folder of the files; empty if this user has none
 * @param clock of the days
 */
record ChoiceStore(Optional<Path> folder, Clock clock) {
    private static final String ENGINE = "engine";
    private static final String MEASURED = "measured";

    /** After these many days drivers, the JDK's fixes and the machine may have changed. */
    private static final int DAYS = 30;

    /** Far more than the size of any file that is written. */
    private static final int MOST_BYTES = 1 << 18;

    static ChoiceStore ofThisUser() {
        return new ChoiceStore(UserFolder.CACHE.ofThisUser(), Clock.systemUTC());
    }

    /** The engine that was the fastest, unless that is long ago. */
    Optional<String> read(MachineKey key) {
        return found(key)
                .filter(choice -> choice.day().isAfter(LocalDate.now(clock).minusDays(DAYS)))
                .map(Choice::engine);
    }

    /** The day on which the engine that {@link #read} returns was measured. */
    Optional<LocalDate> day(MachineKey key) {
        return found(key).map(Choice::day);
    }

    private record Choice(String engine, LocalDate day) {}

    private Optional<Choice> found(MachineKey key) {
        if (folder.isEmpty()) {
            return Optional.empty();
        }
        Properties properties = new Properties();
        try {
            byte[] bytes = InputFile.readSmall(folder.get().resolve(key.fileName()), MOST_BYTES);
            properties.load(new StringReader(new String(bytes, StandardCharsets.UTF_8)));
        } catch (IOException | IllegalArgumentException _) {
            return Optional.empty();
        }
        boolean same = key.facts().entrySet().stream()
                .allMatch(fact -> fact.getValue().equals(properties.getProperty(fact.getKey())));
        String engine = properties.getProperty(ENGINE, "");
        return same && !engine.isEmpty()
                ? day(properties.getProperty(MEASURED, "")).map(day -> new Choice(engine, day))
                : Optional.empty();
    }

    private static Optional<LocalDate> day(String text) {
        try {
            return Optional.of(LocalDate.parse(text));
        } catch (DateTimeParseException _) {
            return Optional.empty();
        }
    }

    /** Remembers the engine as measured today. */
    void write(MachineKey key, String engine) {
        if (folder.isEmpty() || isDevice(folder.get().resolve(key.fileName()))) {
            return;
        }
        Properties properties = new Properties();
        properties.putAll(key.facts());
        properties.setProperty(ENGINE, engine);
        properties.setProperty(MEASURED, LocalDate.now(clock).toString());
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
