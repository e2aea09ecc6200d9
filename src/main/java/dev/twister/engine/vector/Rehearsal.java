package dev.twister.engine.vector;

/** The first frames by one of the two {@link Ways}, beside other frames or none, until the JVM has compiled them. */
interface Rehearsal extends AutoCloseable {
    /** Starts one. */
    @FunctionalInterface
    interface Start {
        /**
         * Of one way.
         *
         * @param walk whether it is the walk through the hierarchy
         */
        Rehearsal of(boolean walk);
    }

    /** Whether frames may go that way. */
    boolean isOver();

    /** Ends it soon; nobody waits for it. */
    @Override
    void close();
}
