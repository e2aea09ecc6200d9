package dev.twister.lanes;

import dev.twister.lanes.Statement.Operation;
import java.util.Comparator;
import java.util.EnumMap;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.PriorityQueue;
import java.util.Set;

/** Finds how long variables live, and gives columns to those that live across units. */
final class Lifetimes {
    /** The driver as one of the users of a variable. */
    private static final int DRIVER = -1;

    private final List<Variable> variables;
    private final Map<Variable, Set<Integer>> users = new HashMap<>();
    private final Map<Integer, Integer> ends = new HashMap<>();
    private final Map<Kind, Integer> columns = new EnumMap<>(Kind.class);
    private int now;

    /**
     * Looks through a plan.
     *
     * @param pinned number of columns of each kind that callers know
     */
    Lifetimes(Plan plan, List<Variable> variables, Map<Kind, Integer> pinned) {
        this.variables = variables;
        columns.putAll(pinned);
        visitSteps(plan.steps);
        for (Kind kind : Kind.values()) {
            place(kind);
        }
    }

    /** Number of columns of a kind. */
    int columns(Kind kind) {
        return columns.get(kind);
    }

    /** Whether a variable with a column is read after a unit. */
    boolean livesAfter(Variable variable, Plan.Unit unit) {
        return variable.hasColumn && (variable.isPinned || variable.last > ends.get(unit.number()));
    }

    private void use(Variable variable, int user) {
        if (variable.first < 0) {
            variable.first = now;
        }
        variable.last = Math.max(variable.last, now);
        users.computeIfAbsent(variable, _ -> new HashSet<>()).add(user);
    }

    private void visitSteps(List<Plan.Step> steps) {
        for (Plan.Step step : steps) {
            switch (step) {
                case Plan.Step.Call(Plan.Unit unit) -> visitUnit(unit);
                case Plan.Step.Flow(Statement statement, List<List<Plan.Step>> blocks) -> {
                    now++;
                    int start = now;
                    Variable mask = Plan.mask(statement);
                    if (mask != null) {
                        use(mask, DRIVER);
                    }
                    for (List<Plan.Step> block : blocks) {
                        visitSteps(block);
                        now++;
                        if (mask != null && Plan.isLoop(statement)) {
                            use(mask, DRIVER);
                        }
                    }
                    endLoop(statement, start);
                }
            }
        }
    }

    private void visitUnit(Plan.Unit unit) {
        unit.statements().forEach(statement -> visit(statement, unit.number()));
        now++;
        ends.put(unit.number(), now);
        // Variables that are set are stored at the unit's end.
        unit.statements().forEach(this::keep);
    }

    private void keep(Statement statement) {
        statement.forEachSet(variable -> variable.last = Math.max(variable.last, now));
        statement.blocks().forEach(block -> block.list().forEach(this::keep));
    }

    private void visit(Statement statement, int unit) {
        now++;
        int start = now;
        statement.forEachRead(variable -> use(variable, unit));
        statement.forEachSet(variable -> use(variable, unit));
        if (statement instanceof Operation operation) {
            use(operation.result(), unit);
            // Places of gathers are read from memory.
            operation.result().hasColumn |= operation.name().equals("safe");
        }
        statement.blocks().forEach(block -> block.list().forEach(inner -> visit(inner, unit)));
        endLoop(statement, start);
    }

    /** What lives into a loop lives until its end. */
    private void endLoop(Statement statement, int start) {
        if (Plan.isLoop(statement)) {
            now++;
            for (Variable variable : variables) {
                if (variable.first >= 0 && variable.first <= start && variable.last > start) {
                    variable.last = now;
                }
            }
        }
    }

    /** Gives columns, each to one variable after the other. */
    private void place(Kind kind) {
        List<Variable> placed = variables.stream()
                .filter(variable -> variable.kind == kind && !variable.isPinned && variable.first >= 0)
                .filter(variable -> variable.hasColumn || users.get(variable).size() > 1)
                .sorted(Comparator.comparingInt(variable -> variable.first))
                .toList();
        PriorityQueue<Variable> living = new PriorityQueue<>(Comparator.comparingInt(variable -> variable.last));
        PriorityQueue<Integer> free = new PriorityQueue<>();
        for (Variable variable : placed) {
            while (!living.isEmpty() && living.peek().last < variable.first) {
                free.add(living.poll().column);
            }
            variable.hasColumn = true;
            variable.column = free.isEmpty() ? columns.merge(kind, 1, Integer::sum) - 1 : free.poll();
            living.add(variable);
        }
    }
}
