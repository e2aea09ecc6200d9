package dev.twister.engine.vector;

/** No rehearsal: complete from the start. */
record Unrehearsed() implements Rehearsal {
    @Override
    public boolean isOver() {
        return true;
    }

    @Override
    public void close() {
        // Nothing to stop.
    }
}
