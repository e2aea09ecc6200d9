package dev.twister.bench.benchmark;

import dev.twister.files.SmallFile;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.file.Path;
import java.util.Optional;
import java.util.Properties;

/** Version of TornadoVM in this JVM, from a file of its SDK, without loading its classes. */
final class TornadoVersion {
    private static final int MOST_BYTES = 1 << 16;

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
        try {
            properties.load(new ByteArrayInputStream(SmallFile.read(release, MOST_BYTES)));
        } catch (IOException | IllegalArgumentException notReadable) {
            return Optional.empty();
        }
        return Optional.ofNullable(properties.getProperty("version"));
    }
}
