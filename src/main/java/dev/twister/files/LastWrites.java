package dev.twister.files;

import java.io.IOException;

/**
 * The files that are written because the process ends; no others are begun then, as nobody waits until they are done.
 */
public final class LastWrites {
    static final String REFUSAL = "the process is ending";

    private static final ScopedValue<Boolean> ALLOWED = ScopedValue.newInstance();

    private LastWrites() {}

    /** Runs what a shutdown hook has to do, which may write files. */
    public static void run(Runnable work) {
        ScopedValue.where(ALLOWED, true).run(work);
    }

    /**
     * Looks whether a file may still be written though the process ends.
     *
     * @throws IOException where this is not within {@link #run}
     */
    static void check() throws IOException {
        if (!ALLOWED.isBound()) {
            throw new IOException(REFUSAL);
        }
    }
}
