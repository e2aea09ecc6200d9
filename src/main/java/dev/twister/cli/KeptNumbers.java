package dev.twister.cli;

import dev.twister.bench.PaperFolder;
import dev.twister.bench.PaperReport;
import java.io.IOException;
import java.nio.file.Path;

/**
 * Keeps an evaluation's numbers on the disk as they come: a process that ends before its time, by a driver's hand perhaps, may
 * not be asked for them any more. Any thread may end it.
 */
final class KeptNumbers {
    private final Path folder;
    private String left = "nothing was measured";
    private boolean ended;

    /** Nothing is written yet to the folder, which must be there. */
    KeptNumbers(Path folder) {
        this.folder = folder;
    }

    /** Writes what was measured so far. An evaluation does not end because that cannot be done. */
    synchronized void keep(PaperReport report) {
        if (ended) {
            return;
        }
        try {
            PaperFolder.writeUnfinished(report, folder);
            left = "what was measured is in " + folder.resolve(PaperFolder.UNFINISHED_JSON) + " and "
                    + folder.resolve(PaperFolder.UNFINISHED_CSV);
        } catch (IOException problem) {
            left = "what was measured is lost: " + problem.getMessage();
        }
    }

    /** Waits for what is being written, so that no half of it stays behind, and writes no more; says what is left. */
    synchronized String end() {
        ended = true;
        return left;
    }
}
