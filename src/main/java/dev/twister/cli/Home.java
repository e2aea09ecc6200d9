package dev.twister.cli;

import java.nio.file.Path;
import java.util.Optional;

/** Twister's own folder, where the shipped scenes and skies are; the launcher names it. */
final class Home {
    private Home() {}

    static Path scenes() {
        return folder().resolve("scenes");
    }

    static Path skyboxes() {
        return folder().resolve("skyboxes");
    }

    static Path folder() {
        return Path.of(Optional.ofNullable(System.getenv("TWISTER_HOME")).orElse(""));
    }
}
