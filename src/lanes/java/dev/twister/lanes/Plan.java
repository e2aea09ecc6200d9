package dev.twister.lanes;

import dev.twister.lanes.Statement.Block;
import dev.twister.lanes.Statement.LaneIf;
import dev.twister.lanes.Statement.LaneLoop;
import dev.twister.lanes.Statement.UniformIf;
import dev.twister.lanes.Statement.UniformLoop;
import java.util.ArrayList;
import java.util.List;

/**
 * Cuts a program into units, which are methods of a limited number of operations, and the control flow between them. C2
 * keeps vectors in registers within a method alone, and compiles none of more than 8,000 bytes of bytecode.
 */
final class Plan {
    /** A method. */
    record Unit(int number, List<Statement> statements) {}

    /** What a driver does. */
    sealed interface Step {
        /** Calls a unit. */
        record Call(Unit unit) implements Step {}

        /** Follows the control flow of a statement, whose blocks are these. */
        record Flow(Statement statement, List<List<Step>> blocks) implements Step {}
    }

    /** The units in the order of their numbers. */
    final List<Unit> units = new ArrayList<>();

    final List<Step> steps;
    private final int limit;

    /**
     * Cuts a program.
     *
     * @param limit largest weight of a unit
     */
    Plan(Block program, int limit) {
        this.limit = limit;
        steps = steps(program);
    }

    private List<Step> steps(Block block) {
        List<Step> steps = new ArrayList<>();
        List<Statement> run = new ArrayList<>();
        int weight = 0;
        for (Statement statement : block.list()) {
            boolean fits = statement.blocks().isEmpty() || statement.weight() <= limit;
            if (!run.isEmpty() && (!fits || weight + statement.weight() > limit)) {
                steps.add(call(run));
                run = new ArrayList<>();
                weight = 0;
            }
            if (fits) {
                run.add(statement);
                weight += statement.weight();
            } else {
                steps.add(new Step.Flow(
                        statement, statement.blocks().stream().map(this::steps).toList()));
            }
        }
        if (!run.isEmpty()) {
            steps.add(call(run));
        }
        return steps;
    }

    private Step call(List<Statement> statements) {
        Unit unit = new Unit(units.size(), statements);
        units.add(unit);
        return new Step.Call(unit);
    }

    /** The mask that a statement's control flow asks for, or null. */
    static Variable mask(Statement statement) {
        return switch (statement) {
            case LaneIf choice -> choice.mask();
            case LaneLoop loop -> loop.mask();
            default -> null;
        };
    }

    /** Whether a statement repeats its blocks. */
    static boolean isLoop(Statement statement) {
        return statement instanceof LaneLoop || statement instanceof UniformLoop;
    }

    /** Whether only the driver's thread decides a statement's control flow, for all lanes. */
    static boolean isUniform(Statement statement) {
        return statement instanceof UniformIf || statement instanceof UniformLoop;
    }
}
