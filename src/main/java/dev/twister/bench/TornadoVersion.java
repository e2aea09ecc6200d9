package dev.twister.bench;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import java.util.Properties;

/** The TornadoVM in this JVM, by its SDK's own file; no class of it is touched. */
final class TornadoVersion {
    private TornadoVersion() {}

    static Optional<String> find() {
        if (ModuleLayer.boot().findModule("tornado.runtime").isEmpty()) {
            return Optional.empty();
        }
        return Optional.of(Optional.ofNullable(System.getenv("TORNADOVM_HOME"))
                .flatMap(sdk -> version(Path.of(sdk, "etc", "tornado.release")))
                .orElse("unknown"));
    }

    private static Optional<String> version(Path release) {
        Properties properties = new Properties();
        try (var reader = Files.newBufferedReader(release)) {
            properties.load(reader);
        } catch (IOException notHere) {
            return Optional.empty();
        }
        return Optional.ofNullable(properties.getProperty("version"));
    }
}
