package dev.twister.lanes;

import java.util.ArrayDeque;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;

/** What is known inside a block: results of operations, and values of the path's floats. */
final class Scope {
    private final Scope outer;
    private final Map<List<Object>, Variable> results = new HashMap<>();

    /** The path's floats whose values are known. */
    final Map<Integer, Value> path = new HashMap<>();

    /** Places of the path's floats that the block stores. */
    final Set<Integer> stored = new TreeSet<>();

    private Scope(Scope outer) {
        this.outer = outer;
    }

    /** One that knows nothing. */
    static Scope empty() {
        return new Scope(null);
    }

    /** A block inside this one. */
    Scope inner() {
        Scope inner = new Scope(this);
        inner.path.putAll(path);
        return inner;
    }

    /** A loop inside this one, which stores these places. */
    Scope loop(Set<Integer> stores) {
        Scope inner = inner();
        inner.path.keySet().removeAll(stores);
        return inner;
    }

    Optional<Variable> find(List<Object> operation) {
        for (Scope scope = this; scope != null; scope = scope.outer) {
            Variable result = scope.results.get(operation);
            if (result != null) {
                return Optional.of(result);
            }
        }
        return Optional.empty();
    }

    void keep(List<Object> operation, Variable result) {
        results.put(operation, result);
    }

    /** Takes over results of a block whose statements became this one's. */
    void keepAll(Scope block) {
        results.putAll(block.results);
    }

    /** Forgets what a block inside has stored. */
    void forget(Scope block) {
        path.keySet().removeAll(block.stored);
        stored.addAll(block.stored);
    }

    void store(int place, Value value) {
        path.put(place, value);
        stored.add(place);
    }

    /** The variable of places that are 0 outside of one of the masks, if there is one. */
    Optional<Variable> safe(Variable places, ArrayDeque<Variable> masks) {
        return masks.reversed().stream()
                .flatMap(mask -> find(List.of("safe", places, mask)).stream())
                .findFirst();
    }
}
