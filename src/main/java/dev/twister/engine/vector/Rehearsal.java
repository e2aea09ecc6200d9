package dev.twister.engine.vector;

/** The first walks through the hierarchy, beside the frames, until the JVM has compiled them. */
interface Rehearsal extends AutoCloseable {
    /** Whether frames may walk. */
    boolean isOver();

    /** Ends it soon; nobody waits for it. */
    @Override
    void close();
}
