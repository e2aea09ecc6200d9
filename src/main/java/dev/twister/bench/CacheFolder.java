package dev.twister.bench;

import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;

/** Where a system wants a user's caches to be. */
final class CacheFolder {
    private static final String OWN = "twister";

    private CacheFolder() {}

    /**
     * Twister's own folder there, which need not exist yet.
     *
     * @param system as in the property os.name
     * @param home the user's folder
     * @param environment the process's variables
     */
    static Optional<Path> find(String system, String home, Map<String, String> environment) {
        String name = system.toLowerCase(Locale.ROOT);
        if (name.startsWith("windows")) {
            return absolute(environment.get("LOCALAPPDATA")).map(folder -> folder.resolve(OWN));
        }
        Optional<Path> user = absolute(home);
        if (name.startsWith("mac")) {
            return user.map(
                    folder -> folder.resolve("Library").resolve("Caches").resolve(OWN));
        }
        // The XDG specification: a relative path is to be ignored.
        return absolute(environment.get("XDG_CACHE_HOME"))
                .or(() -> user.map(folder -> folder.resolve(".cache")))
                .map(folder -> folder.resolve(OWN));
    }

    private static Optional<Path> absolute(String path) {
        try {
            return Optional.ofNullable(path)
                    .filter(text -> !text.isEmpty())
                    .map(Path::of)
                    .filter(Path::isAbsolute);
        } catch (InvalidPathException _) {
            return Optional.empty();
        }
    }
}
