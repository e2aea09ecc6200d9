package dev.twister.exr;

import java.util.zip.DataFormatException;

/** What damaged files break. */
final class ExrDamage {
    private ExrDamage() {}

    /** Ends the reading of a file that is not as its format says. */
    static void check(boolean right) throws DataFormatException {
        if (!right) {
            throw new DataFormatException();
        }
    }
}
