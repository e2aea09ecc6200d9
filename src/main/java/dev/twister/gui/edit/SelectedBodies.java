package dev.twister.gui.edit;

import java.util.Collection;
import java.util.Collections;
import java.util.LinkedHashSet;
import java.util.SequencedSet;
import java.util.function.IntPredicate;

/**
 * The selected bodies, by their {@link BodyNumber}.
 *
 * @param bodies in the order in which they were selected
 * @param active the body whose properties are shown; {@link BodyNumber#NONE} if none is selected
 */
public record SelectedBodies(SequencedSet<Integer> bodies, int active) {
    public static final SelectedBodies NONE = new SelectedBodies(new LinkedHashSet<>(), BodyNumber.NONE);

    /**
     * Copies the bodies.
     *
     * @throws IllegalArgumentException if the active body is not one of them
     */
    public SelectedBodies {
        if (bodies.isEmpty() ? active != BodyNumber.NONE : !bodies.contains(active)) {
            throw new IllegalArgumentException("the active body is not selected");
        }
        bodies = Collections.unmodifiableSequencedSet(new LinkedHashSet<>(bodies));
    }

    /** The body alone; nothing if it is {@link BodyNumber#NONE}. */
    public static SelectedBodies of(int body) {
        return body == BodyNumber.NONE
                ? NONE
                : new SelectedBodies(new LinkedHashSet<>(Collections.singleton(body)), body);
    }

    /** All of them, the last one active. */
    public static SelectedBodies of(Collection<Integer> bodies) {
        SequencedSet<Integer> selected = new LinkedHashSet<>(bodies);
        return selected.isEmpty() ? NONE : new SelectedBodies(selected, selected.getLast());
    }

    public int count() {
        return bodies.size();
    }

    public boolean contains(int body) {
        return bodies.contains(body);
    }

    /** With that body as the active one, or without it. */
    public SelectedBodies toggled(int body) {
        SequencedSet<Integer> toggled = new LinkedHashSet<>(bodies);
        if (toggled.remove(body)) {
            return active == body ? of(toggled) : new SelectedBodies(toggled, active);
        }
        toggled.add(body);
        return new SelectedBodies(toggled, body);
    }

    /** The same bodies, another one of them active. */
    public SelectedBodies withActive(int body) {
        return new SelectedBodies(bodies, body);
    }

    /** The bodies that match; if the active one does not, the last one becomes active. */
    public SelectedBodies where(IntPredicate kept) {
        SequencedSet<Integer> rest = new LinkedHashSet<>(bodies);
        rest.removeIf(body -> !kept.test(body));
        return rest.contains(active) ? new SelectedBodies(rest, active) : of(rest);
    }
}
