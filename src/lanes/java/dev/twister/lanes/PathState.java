package dev.twister.lanes;

import dev.twister.lanes.Statement.Block;
import dev.twister.lanes.Statement.LaneIf;
import dev.twister.lanes.Statement.LaneLoop;
import dev.twister.lanes.Statement.Operation;
import dev.twister.lanes.Statement.PathStore;
import dev.twister.lanes.Statement.UniformIf;
import dev.twister.lanes.Statement.UniformLoop;
import java.util.Set;
import java.util.TreeSet;

/** Finds which of the path's floats a program may read before it stores them. */
final class PathState {
    private final Set<Integer> read = new TreeSet<>();

    private PathState() {}

    /** Places of the floats that are read. */
    static Set<Integer> of(Block program, Variable mask) {
        PathState state = new PathState();
        state.visit(program, mask, new TreeSet<>());
        return state.read;
    }

    /** Adds what a block stores in all its lanes to what is stored before it. */
    private Set<Integer> visit(Block block, Variable mask, Set<Integer> before) {
        Set<Integer> stored = new TreeSet<>(before);
        for (Statement statement : block.list()) {
            switch (statement) {
                case Operation operation
                when operation.name().equals("path") -> {
                    Integer place = (Integer) operation.arguments().getFirst();
                    if (!stored.contains(place)) {
                        read.add(place);
                    }
                }
                case PathStore store when store.mask() == mask -> stored.add(store.place());
                case LaneIf choice -> visit(choice.body(), choice.mask(), stored);
                case UniformIf choice -> {
                    Set<Integer> both = visit(choice.then(), mask, stored);
                    both.retainAll(visit(choice.otherwise(), mask, stored));
                    stored.addAll(both);
                }
                case LaneLoop loop -> {
                    visit(loop.condition(), loop.mask(), stored);
                    visit(loop.body(), loop.mask(), stored);
                }
                case UniformLoop loop -> visit(loop.body(), mask, stored);
                default -> {}
            }
        }
        return stored;
    }
}
