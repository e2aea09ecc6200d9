package dev.twister.engine.vector;

import dev.twister.world.FrameInput;
import java.util.Optional;

/**
 * Chooses one of two ways to render a frame: by brute force, or through the hierarchy. Their rounding differs, so the
 * choice depends on the frame alone. The first frames of a way take seconds until the JIT compiler has compiled its
 * code. Therefore the hierarchy is rehearsed while the frames by brute force lead up to a crowd, and while the engine
 * rests, the way not used so far is rehearsed for the next scene.
 */
final class HierarchyChoice implements AutoCloseable {
    /** No rehearsal starts before this many frames, while the engine itself warms up. */
    private static final int FIRST_FRAMES = 50;

    private final int crowd;
    private final Rehearsal.Start rehearsals;
    private Optional<Rehearsal> rehearsal = Optional.empty();
    private boolean walked;
    private boolean passed;
    private int frames;

    /**
     * Prepares the choice; no rehearsal starts yet.
     *
     * @param crowd the body count from which the hierarchy is used
     */
    HierarchyChoice(int crowd, Rehearsal.Start rehearsals) {
        this.crowd = crowd;
        this.rehearsals = rehearsals;
    }

    /** Whether the next frame is rendered through the hierarchy. */
    boolean walk(FrameInput input) {
        boolean crowdToCome = !walked && input.bodies().room() >= crowd;
        if (!crowdToCome) {
            // A rehearsal at rest competes for the CPU with rendering; compiled code stays.
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

    /** Called when no frame is requested for a while. */
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
