package dev.twister.lanes;

import dev.twister.lanes.Statement.Block;
import dev.twister.lanes.Statement.LaneIf;
import dev.twister.lanes.Statement.LaneLoop;
import dev.twister.lanes.Statement.Operation;
import dev.twister.lanes.Statement.UniformIf;
import dev.twister.lanes.Statement.UniformLoop;
import java.util.HashSet;
import java.util.Set;
import java.util.function.Predicate;

/** Takes away what nothing is stored of, such as the negation of a condition without an {@code else}. */
final class Unused {
    private final Set<Variable> used = new HashSet<>();

    private Unused() {}

    static void removeFrom(Block program) {
        Unused unused = new Unused();
        int before = -1;
        while (before < unused.used.size()) {
            before = unused.used.size();
            unused.mark(program);
        }
        unused.remove(program);
    }

    /** Marks what the statements read whose results are used. */
    private void mark(Block block) {
        for (Statement statement : block.list()) {
            statement.blocks().forEach(this::mark);
            if (isUsed(statement)) {
                statement.forEachRead(used::add);
            }
        }
    }

    private boolean isUsed(Statement statement) {
        Predicate<Variable> isRead = variable -> variable.isPinned || used.contains(variable);
        boolean[] found = {false};
        statement.forEachSet(variable -> found[0] |= isRead.test(variable));
        return switch (statement) {
            case Operation operation -> isRead.test(operation.result());
            case Statement.PathStore _, Statement.ScratchStore _ -> true;
            case LaneIf choice -> isUsed(choice.body());
            case UniformIf choice -> isUsed(choice.then()) || isUsed(choice.otherwise());
            case LaneLoop loop -> isUsed(loop.body());
            case UniformLoop loop -> isUsed(loop.body());
            default -> found[0];
        };
    }

    private boolean isUsed(Block block) {
        return block.list().stream().anyMatch(this::isUsed);
    }

    private void remove(Block block) {
        block.list().removeIf(statement -> !isUsed(statement));
        block.list().forEach(statement -> statement.blocks().forEach(this::remove));
    }
}
