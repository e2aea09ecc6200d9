package dev.twister.engine.vector;

import dev.twister.world.FrameInput;
import java.util.Optional;
import java.util.function.Supplier;

/**
 * By which of two ways frames are drawn: past all bodies, or on a walk through the hierarchy. What the JVM has not compiled
 * takes more than a second for a frame. So where a crowd is to come, the walk is rehearsed, and the few that are there
 * already are drawn past until then.
 */
final class Ways implements AutoCloseable {
    /** An engine that is still warming itself is left alone. */
    private static final int FIRST_FRAMES = 50;

    /** From so many times a crowd on, passing all takes so long that the walk is begun, rehearsed or not. */
    private static final int MOST_CROWDS = 2;

    private final int crowd;
    private final Supplier<Rehearsal> rehearsals;
    private Optional<Rehearsal> rehearsal = Optional.empty();
    private boolean known;
    private int frames;

    /**
     * Draws nothing yet.
     *
     * @param crowd from how many bodies on the hierarchy is walked
     * @param rehearsals starts one
     */
    Ways(int crowd, Supplier<Rehearsal> rehearsals) {
        this.crowd = crowd;
        this.rehearsals = rehearsals;
    }

    /** Whether the next frame is a walk. */
    boolean walk(FrameInput input) {
        if (!known && rehearsal.isEmpty() && input.room() >= crowd && frames++ >= FIRST_FRAMES) {
            rehearsal = Optional.of(rehearsals.get());
        }
        boolean waits = rehearsal.filter(begun -> !begun.isOver()).isPresent();
        boolean walk = input.bodies() >= (waits ? MOST_CROWDS * crowd : crowd);
        if (walk && !known) {
            known = true;
            close();
        }
        return walk;
    }

    @Override
    public void close() {
        rehearsal.ifPresent(Rehearsal::close);
        rehearsal = Optional.empty();
    }
}
