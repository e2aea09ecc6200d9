package dev.twister.lanes;

import com.sun.source.tree.AssignmentTree;
import com.sun.source.tree.CompoundAssignmentTree;
import com.sun.source.tree.ExpressionStatementTree;
import com.sun.source.tree.ExpressionTree;
import com.sun.source.tree.ForLoopTree;
import com.sun.source.tree.IdentifierTree;
import com.sun.source.tree.StatementTree;
import com.sun.source.tree.Tree;
import com.sun.source.tree.UnaryTree;
import com.sun.source.tree.VariableTree;
import com.sun.source.util.TreeScanner;
import dev.twister.lanes.Statement.Assignment;
import dev.twister.lanes.Statement.Block;
import dev.twister.lanes.Statement.LaneLoop;
import dev.twister.lanes.Statement.MaskedAssignment;
import dev.twister.lanes.Statement.Narrowing;
import dev.twister.lanes.Statement.UniformLoop;
import dev.twister.lanes.Value.Constant;
import dev.twister.lanes.Value.Lanes;
import dev.twister.lanes.Value.Uniform;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.Map;
import java.util.Set;

/** Runs loops: unrolled where short, as Java's where all lanes share the index, else until no lane goes on. */
final class Loops {
    private static final int MOST_UNROLLED = 3;
    private static final int MOST_TRIPS = 100;

    private final Builder builder;
    private final Statements statements;
    private final Expressions expressions;
    private int indexes;

    /** Bodies go to the statements. */
    Loops(Builder builder, Statements statements, Expressions expressions) {
        this.builder = builder;
        this.statements = statements;
        this.expressions = expressions;
    }

    /** Runs a {@code for}. */
    void run(ForLoopTree loop) {
        if (loop.getInitializer().size() != 1
                || !(loop.getInitializer().getFirst() instanceof VariableTree index)
                || loop.getUpdate().size() != 1) {
            throw new Refusal("a for without one index and one step");
        }
        String name = index.getName().toString();
        if (assigned(loop.getStatement()).contains(name)) {
            throw new Refusal("the loop's body changes its index " + name);
        }
        Map<String, Value> values = statements.activation().values;
        statements.run(index);
        Value from = values.get(name);
        Value condition = expressions.compute(loop.getCondition());
        int trips = from instanceof Constant && condition instanceof Constant ? trips(loop, name) : MOST_TRIPS;
        if (trips <= MOST_UNROLLED) {
            for (int trip = 0; trip < trips; trip++) {
                statements.run(loop.getStatement());
                step(loop);
            }
        } else if (from.varies() || condition.varies() || moves(loop)) {
            run(loop.getCondition(), loop.getStatement(), loop.getUpdate().getFirst());
        } else {
            runUniform(loop, name, from);
        }
        statements.activation().values.remove(name);
    }

    private void step(ForLoopTree loop) {
        statements.runExpression(loop.getUpdate().getFirst().getExpression());
    }

    private int trips(ForLoopTree loop, String index) {
        Map<String, Value> values = statements.activation().values;
        Value from = values.get(index);
        int trips = 0;
        while (expressions.compute(loop.getCondition()).equals(new Constant(true)) && trips < MOST_TRIPS) {
            step(loop);
            trips++;
        }
        values.put(index, from);
        return trips;
    }

    /** Whether the body changes what the condition reads. */
    private static boolean moves(ForLoopTree loop) {
        Set<String> inBody = assigned(loop.getStatement());
        boolean[] found = {false};
        new TreeScanner<Void, Void>() {
            @Override
            public Void visitIdentifier(IdentifierTree name, Void nothing) {
                found[0] |= inBody.contains(name.getName().toString());
                return null;
            }
        }.scan(loop.getCondition(), null);
        return found[0];
    }

    /** The local variables that are set there. */
    private static Set<String> assigned(Tree... trees) {
        Set<String> found = new LinkedHashSet<>();
        TreeScanner<Void, Void> scanner = new TreeScanner<>() {
            @Override
            public Void visitAssignment(AssignmentTree set, Void nothing) {
                found.add(set.getVariable().toString());
                return super.visitAssignment(set, null);
            }

            @Override
            public Void visitCompoundAssignment(CompoundAssignmentTree set, Void nothing) {
                found.add(set.getVariable().toString());
                return super.visitCompoundAssignment(set, null);
            }

            @Override
            public Void visitUnary(UnaryTree unary, Void nothing) {
                if (unary.getKind() == Tree.Kind.POSTFIX_INCREMENT || unary.getKind() == Tree.Kind.POSTFIX_DECREMENT) {
                    found.add(unary.getExpression().toString());
                }
                return super.visitUnary(unary, null);
            }
        };
        for (Tree tree : trees) {
            scanner.scan(tree, null);
        }
        return found;
    }

    /** Variables of their own for what a loop changes, set before it. */
    private Map<String, Variable> carried(Set<String> changed) {
        Activation activation = statements.activation();
        Map<String, Variable> carried = new LinkedHashMap<>();
        for (String name : changed) {
            if (activation.values.containsKey(name)) {
                Kind kind = activation.floats.get(name) ? Kind.FLOAT : Kind.INT;
                Variable variable = builder.variable(kind, true);
                Value before = builder.as(kind, activation.values.get(name));
                builder.block.list().add(new Assignment(variable, before));
                carried.put(name, variable);
                activation.values.put(name, new Lanes(variable));
            }
        }
        return carried;
    }

    /** Sets a loop's variables at its body's end, all from values before that: in all lanes, or in a mask's. */
    private void carry(Block body, Map<String, Variable> carried, Map<String, Value> values, Variable mask) {
        Block sets = new Block();
        for (Map.Entry<String, Variable> entry : carried.entrySet()) {
            Variable variable = entry.getValue();
            Value value = values.get(entry.getKey());
            if (!value.equals(new Lanes(variable))) {
                Value converted = builder.atEndOf(body, variable.kind, value);
                if (converted instanceof Lanes(Variable other) && carried.containsValue(other)) {
                    Variable copy = builder.variable(other.kind, true);
                    body.list().add(new Assignment(copy, converted));
                    converted = new Lanes(copy);
                }
                sets.list()
                        .add(
                                mask == null
                                        ? new Assignment(variable, converted)
                                        : new MaskedAssignment(variable, converted, mask));
            }
        }
        body.list().addAll(sets.list());
    }

    /** Runs a loop whose lanes end by themselves; the step may be missing. */
    void run(ExpressionTree condition, StatementTree body, ExpressionStatementTree step) {
        Map<String, Variable> carried = carried(assigned(body, step));
        Variable mask = builder.variable(Kind.MASK, true);
        builder.block.list().add(new Assignment(mask, new Lanes(builder.mask())));
        // The first run only tells which of the path's floats the loop stores.
        Scope trial = builder.scope.loop(builder.scope.path.keySet());
        runBody(condition, body, step, carried, mask, trial);
        Scope scope = builder.scope.loop(trial.stored);
        builder.block.list().add(runBody(condition, body, step, carried, mask, scope));
        builder.scope.forget(scope);
    }

    private LaneLoop runBody(
            ExpressionTree condition,
            StatementTree body,
            ExpressionStatementTree step,
            Map<String, Variable> carried,
            Variable mask,
            Scope scope) {
        Activation activation = statements.activation();
        Map<String, Value> outer = activation.values;
        activation.values = new LinkedHashMap<>(outer);
        Block test = new Block();
        Block turn = new Block();
        builder.within(mask, () -> {
            builder.into(test, scope, () -> {
                Value goesOn = builder.asCondition(expressions.compute(condition));
                return test.list().add(new Narrowing(mask, goesOn));
            });
            return builder.into(turn, scope, () -> {
                statements.run(body);
                statements.run(step);
                carry(turn, carried, activation.values, mask);
                return turn;
            });
        });
        activation.values = outer;
        return new LaneLoop(test, mask, turn);
    }

    private void runUniform(ForLoopTree loop, String index, Value from) {
        Activation activation = statements.activation();
        Set<String> changed = assigned(loop.getStatement());
        Map<String, Variable> carried = carried(changed);
        String name = "index" + indexes++;
        activation.values.put(index, new Uniform(name, Kind.INT));
        String condition = expressions.compute(loop.getCondition()).text();
        step(loop);
        String next = activation.values.get(index).text();
        activation.values.put(index, new Uniform(name, Kind.INT));
        Scope trial = builder.scope.loop(builder.scope.path.keySet());
        runTurn(loop, carried, trial);
        Scope scope = builder.scope.loop(trial.stored);
        Block body = runTurn(loop, carried, scope);
        builder.scope.forget(scope);
        builder.block.list().add(new UniformLoop(name, from.text(), condition, next, body));
    }

    private Block runTurn(ForLoopTree loop, Map<String, Variable> carried, Scope scope) {
        Activation activation = statements.activation();
        Map<String, Value> outer = activation.values;
        activation.values = new LinkedHashMap<>(outer);
        Block body = new Block();
        builder.into(body, scope, () -> {
            statements.run(loop.getStatement());
            carry(body, carried, activation.values, null);
            return body;
        });
        activation.values = outer;
        return body;
    }
}
