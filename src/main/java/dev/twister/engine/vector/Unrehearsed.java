package dev.twister.engine.vector;

/** No rehearsal: over at once. */
record Unrehearsed() implements Rehearsal {
    @Override
    public boolean isOver() {
        return true;
    }

    @Override
    public void close() {
        // Nothing goes on.
    }
}
