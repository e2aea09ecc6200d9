package dev.twister;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Assumptions;

/** Creates symbolic links where the system supports them. */
public final class Links {
    private Links() {}

    /** Creates a link; skips the test if that fails. */
    public static Path make(Path link, Path target) {
        try {
            return Files.createSymbolicLink(link, target);
        } catch (IOException | UnsupportedOperationException noLinksHere) {
            return Assumptions.abort("no symbolic links here");
        }
    }
}
