package dev.twister.cli;

import dev.twister.files.LastWrites;

/**
 * Speaks up where the process ends in the middle of long work: stopped by a person, or by a device's driver, some of which
 * end it without a word.
 */
final class Unfinished implements AutoCloseable {
    private final Thread hook;

    private Unfinished(Thread hook) {
        this.hook = hook;
    }

    /**
     * The work begins; it is done when the result is closed.
     *
     * @param speak called once where the process ends before that, on another thread than the work's, which goes on beside it
     */
    static Unfinished until(Runnable speak) {
        Thread hook = Thread.ofPlatform().name("unfinished").unstarted(() -> LastWrites.run(speak));
        Runtime.getRuntime().addShutdownHook(hook);
        return new Unfinished(hook);
    }

    @Override
    public void close() {
        try {
            Runtime.getRuntime().removeShutdownHook(hook);
        } catch (IllegalStateException _) {
            // The process ends already: the hook has spoken, or will.
        }
    }
}
