package dev.twister.lanes;

import com.sun.source.tree.StatementTree;
import dev.twister.lanes.Statement.Assignment;
import dev.twister.lanes.Statement.Block;
import dev.twister.lanes.Statement.LaneIf;
import dev.twister.lanes.Statement.MaskedAssignment;
import dev.twister.lanes.Statement.Operation;
import dev.twister.lanes.Statement.PathStore;
import dev.twister.lanes.Statement.UniformIf;
import dev.twister.lanes.Value.Constant;
import dev.twister.lanes.Value.Lanes;
import dev.twister.lanes.Value.Uniform;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;

/** Runs {@code if}s. */
record Choices(Builder builder, Statements statements, int flat) {
    /** What an arm has done: its statements, the local variables and the scope at its end. */
    private record Arm(Block block, Map<String, Value> values, Scope scope) {}

    void run(Value condition, StatementTree then, StatementTree otherwise) {
        switch (condition) {
            case Constant(Object holds) -> statements.run((Boolean) holds ? then : otherwise);
            case Uniform uniform -> runUniform(uniform, then, otherwise);
            default -> runLanes(condition, then, otherwise);
        }
    }

    private Arm arm(StatementTree statement) {
        Activation activation = statements.activation();
        Map<String, Value> outer = activation.values;
        Block block = new Block();
        Scope scope = builder.scope.inner();
        activation.values = new LinkedHashMap<>(outer);
        Map<String, Value> values = builder.into(block, scope, () -> {
            statements.run(statement);
            return activation.values;
        });
        activation.values = outer;
        return new Arm(block, values, scope);
    }

    private void runUniform(Uniform condition, StatementTree then, StatementTree otherwise) {
        Arm first = arm(then);
        Arm second = arm(otherwise);
        Map<String, Value> values = statements.activation().values;
        for (String name : List.copyOf(values.keySet())) {
            Value a = first.values.get(name);
            Value b = second.values.get(name);
            if (a.equals(b)) {
                values.put(name, a);
            } else if (!a.varies() && !b.varies()) {
                values.put(name, builder.choose(condition, a, b));
            } else {
                Variable merged = builder.variable(kind(name, a, b), true);
                set(first.block, merged, a);
                set(second.block, merged, b);
                builder.block.list().add(new Assignment(merged, zero(merged.kind)));
                values.put(name, new Lanes(merged));
            }
        }
        builder.scope.forget(first.scope);
        builder.scope.forget(second.scope);
        builder.block.list().add(new UniformIf(condition.text(), first.block, second.block));
    }

    private void set(Block block, Variable variable, Value value) {
        block.list().add(new Assignment(variable, builder.atEndOf(block, variable.kind, value)));
    }

    private static Value zero(Kind kind) {
        return switch (kind) {
            case FLOAT -> new Constant(0f);
            case INT -> new Constant(0);
            case MASK -> new Constant(false);
        };
    }

    private Kind kind(String name, Value... values) {
        if (statements.activation().floats.get(name)) {
            return Kind.FLOAT;
        }
        for (Value value : values) {
            if (!value.isBit()) {
                return Kind.INT;
            }
        }
        return Kind.MASK;
    }

    private void runLanes(Value condition, StatementTree then, StatementTree otherwise) {
        Value holds = new Lanes(((Lanes) condition).variable());
        Variable thenMask = builder.narrowed(holds);
        Arm first = builder.within(thenMask, () -> arm(then));
        Variable elseMask = otherwise == null
                ? thenMask
                : builder.add(Kind.MASK, "maskAndNot", new Lanes(builder.mask()), holds)
                        .variable();
        Arm second = builder.within(elseMask, () -> arm(otherwise));
        if (first.block.weight() + second.block.weight() <= flat && isFlat(first.block) && isFlat(second.block)) {
            flatten(holds, first, second);
        } else {
            branch(first, thenMask, second, elseMask);
        }
    }

    /** Whether all lanes may run it: it has operations alone that do nothing in other lanes. */
    private static boolean isFlat(Block block) {
        return block.list().stream()
                .allMatch(statement -> statement instanceof PathStore
                        || statement instanceof Assignment
                        || statement instanceof MaskedAssignment
                        || (statement instanceof Operation operation
                                && !operation.name().equals("gather")
                                && !operation.name().startsWith("scratch")));
    }

    private void flatten(Value condition, Arm first, Arm second) {
        Scope scope = builder.scope;
        builder.block.list().addAll(first.block.list());
        scope.keepAll(first.scope);
        builder.block.list().addAll(second.block.list());
        scope.keepAll(second.scope);
        Set<Integer> stored = new TreeSet<>(first.scope.stored);
        stored.addAll(second.scope.stored);
        for (int place : stored) {
            Value a = first.scope.path.get(place);
            Value b = second.scope.path.get(place);
            scope.path.remove(place);
            if (a != null && b != null) {
                scope.path.put(place, builder.choose(condition, a, b));
            }
            scope.stored.add(place);
        }
        if (second.block.list().isEmpty()) {
            // Loads of the arm are loads of all lanes.
            first.scope.path.forEach((place, value) -> {
                if (!stored.contains(place)) {
                    scope.path.putIfAbsent(place, value);
                }
            });
        }
        Activation activation = statements.activation();
        for (String name : List.copyOf(activation.values.keySet())) {
            Value a = first.values.get(name);
            Value b = second.values.get(name);
            if (!a.equals(b)) {
                Value chosen = builder.choose(condition, a, b);
                activation.values.put(name, activation.floats.get(name) ? builder.asFloat(chosen) : chosen);
            } else {
                activation.values.put(name, a);
            }
        }
    }

    private void branch(Arm first, Variable thenMask, Arm second, Variable elseMask) {
        Map<String, Value> values = statements.activation().values;
        for (String name : List.copyOf(values.keySet())) {
            Value old = values.get(name);
            Value a = first.values.get(name);
            Value b = second.values.get(name);
            if (!a.equals(old) || !b.equals(old)) {
                Variable merged = builder.variable(kind(name, old, a, b), true);
                set(builder.block, merged, old);
                setMasked(first.block, merged, a, old, thenMask);
                setMasked(second.block, merged, b, old, elseMask);
                values.put(name, new Lanes(merged));
            }
        }
        builder.scope.forget(first.scope);
        builder.block.list().add(new LaneIf(thenMask, first.block));
        if (!second.block.list().isEmpty()) {
            builder.scope.forget(second.scope);
            builder.block.list().add(new LaneIf(elseMask, second.block));
        }
    }

    private void setMasked(Block block, Variable variable, Value value, Value old, Variable mask) {
        if (!value.equals(old)) {
            Value converted = builder.atEndOf(block, variable.kind, value);
            block.list().add(new MaskedAssignment(variable, converted, mask));
        }
    }
}
