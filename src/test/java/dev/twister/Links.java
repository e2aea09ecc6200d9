package dev.twister;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Assumptions;

/** Makes symbolic links, where the system has some. */
public final class Links {
    private Links() {}

    /** Makes a link; the test is left where that cannot be done. */
    public static Path make(Path link, Path target) {
        try {
            return Files.createSymbolicLink(link, target);
        } catch (IOException | UnsupportedOperationException noLinksHere) {
            return Assumptions.abort("no symbolic links here");
        }
    }
}
