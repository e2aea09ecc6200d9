package dev.twister.engine.vector;

import dev.twister.world.FrameInput;
import java.util.Optional;

/**
 * By which of two ways a frame is drawn: by brute force, or through the hierarchy. They round differently, so the frame
 * alone decides. What the JVM has not compiled takes seconds for a frame. So where a crowd is to come, the hierarchy is
 * rehearsed beside the frames by brute force; and while nothing is drawn, the way that has not been taken yet is
 * rehearsed, as another scene may be next.
 */
final class Ways implements AutoCloseable {
    /** An engine that is still warming itself is left alone. */
    private static final int FIRST_FRAMES = 50;

    private final int crowd;
    private final Rehearsal.Start rehearsals;
    private Optional<Rehearsal> rehearsal = Optional.empty();
    private boolean walked;
    private boolean passed;
    private int frames;

    /**
     * Draws nothing yet.
     *
     * @param crowd from how many bodies on the hierarchy is walked
     */
    Ways(int crowd, Rehearsal.Start rehearsals) {
        this.crowd = crowd;
        this.rehearsals = rehearsals;
    }

    /** Whether the next frame is a walk. */
    boolean walk(FrameInput input) {
        boolean crowdToCome = !walked && input.bodies().room() >= crowd;
        if (!crowdToCome) {
            // Starts at rest, as rendering needs the processor; compiled code stays compiled.
            endUnfinished();
        } else if (rehearsal.isEmpty() && frames++ >= FIRST_FRAMES) {
            rehearsal = Optional.of(rehearsals.of(true));
        }
        boolean walk = input.bodyCount() >= crowd;
        if (walk) {
            walked = true;
            endUnfinished();
        } else {
            passed = true;
        }
        return walk;
    }

    /** Nothing is drawn for now. */
    void rest() {
        if (walked != passed && rehearsal.isEmpty()) {
            rehearsal = Optional.of(rehearsals.of(passed));
        }
    }

    private boolean isUnfinished() {
        return rehearsal.filter(begun -> !begun.isOver()).isPresent();
    }

    private void endUnfinished() {
        if (isUnfinished()) {
            close();
        }
    }

    @Override
    public void close() {
        rehearsal.ifPresent(Rehearsal::close);
        rehearsal = Optional.empty();
    }
}
