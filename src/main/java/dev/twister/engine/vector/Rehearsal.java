package dev.twister.engine.vector;

/**
 * Renders frames in one of the two {@link HierarchyChoice} beforehand, until the JIT compiler has compiled the code.
 */
interface Rehearsal extends AutoCloseable {
    /** Starts a rehearsal. */
    @FunctionalInterface
    interface Start {
        /**
         * Starts to rehearse one way.
         *
         * @param walk true for the hierarchy, false for brute force
         */
        Rehearsal of(boolean walk);
    }

    /** Whether the rehearsal is complete. */
    boolean isOver();

    /** Asks the rehearsal to stop and returns at once. */
    @Override
    void close();
}
