package dev.twister.cli.file;

import java.net.URISyntaxException;
import java.net.URL;
import java.nio.file.FileSystemNotFoundException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.CodeSource;
import java.util.Objects;
import java.util.Optional;
import java.util.stream.Stream;

/** Twister's own folder, where the shipped scenes and skies are. */
public final class Home {
    private static final String SCENES = "scenes";
    private static final String SCHEMA = "scene.schema.json";

    private Home() {}

    public static Path scenes() {
        return folder().resolve(SCENES);
    }

    public static Path skyboxes() {
        return folder().resolve("skyboxes");
    }

    public static Path folder() {
        return folder(Optional.ofNullable(System.getenv("TWISTER_HOME")), program());
    }

    /**
     * The folder that is named; else the nearest one above the program with scenes in it; else the current one.
     *
     * @param program the jar, or the folder of the classes
     */
    public static Path folder(Optional<String> named, Optional<Path> program) {
        return named.map(Path::of)
                .or(() -> program.flatMap(jar -> Stream.iterate(jar.getParent(), Objects::nonNull, Path::getParent)
                        .filter(folder -> Files.isRegularFile(folder.resolve(SCENES, SCHEMA)))
                        .findFirst()))
                .orElse(Path.of(""));
    }

    private static Optional<Path> program() {
        return Optional.ofNullable(Home.class.getProtectionDomain().getCodeSource())
                .map(CodeSource::getLocation)
                .flatMap(Home::path);
    }

    private static Optional<Path> path(URL place) {
        try {
            return Optional.of(Path.of(place.toURI()).toAbsolutePath());
        } catch (URISyntaxException | IllegalArgumentException | FileSystemNotFoundException _) {
            return Optional.empty();
        }
    }
}
