package dev.twister.lanes;

import com.sun.source.tree.ArrayAccessTree;
import com.sun.source.tree.AssignmentTree;
import com.sun.source.tree.BlockTree;
import com.sun.source.tree.CompoundAssignmentTree;
import com.sun.source.tree.ExpressionStatementTree;
import com.sun.source.tree.ExpressionTree;
import com.sun.source.tree.ForLoopTree;
import com.sun.source.tree.IdentifierTree;
import com.sun.source.tree.IfTree;
import com.sun.source.tree.MethodInvocationTree;
import com.sun.source.tree.ReturnTree;
import com.sun.source.tree.StatementTree;
import com.sun.source.tree.Tree;
import com.sun.source.tree.UnaryTree;
import com.sun.source.tree.VariableTree;
import com.sun.source.tree.WhileLoopTree;
import dev.twister.lanes.Value.Constant;
import java.util.List;
import java.util.function.Supplier;

/** Runs methods for lanes; calls are inlined. */
final class Statements {
    private final Sources sources;
    private final Builder builder;
    private final Expressions expressions;
    private final Choices choices;
    private final Loops loops;
    private Activation activation;

    /**
     * Adds to the builder.
     *
     * @param flat largest weight of an {@code if} without loads that becomes choices in all lanes
     */
    Statements(Sources sources, Builder builder, int flat) {
        this.sources = sources;
        this.builder = builder;
        expressions = new Expressions(sources, builder, this);
        choices = new Choices(builder, this, flat);
        loops = new Loops(builder, this, expressions);
    }

    Activation activation() {
        return activation;
    }

    /** Computes a constant whose initializer sees a class's names. */
    Value inClass(String owner, Supplier<Value> constant) {
        Activation outer = activation;
        activation = new Activation(new Sources.Method(owner, null, null));
        Value value = constant.get();
        activation = outer;
        return value;
    }

    /** The value of a class's constant. */
    int constant(String owner, String name) {
        Value value = inClass(owner, () -> expressions.compute(sources.constant(owner, name)));
        return value instanceof Constant(Integer number) ? number : 0;
    }

    /** Runs a method; what it returns, or null where that is nothing. */
    Value call(Sources.Method method, List<Value> arguments) {
        Activation caller = activation;
        String callerSource = builder.source;
        activation = new Activation(method);
        builder.source = method.name();
        for (int k = 0; k < arguments.size(); k++) {
            declare(method.tree().getParameters().get(k), arguments.get(k));
        }
        List<? extends StatementTree> body = method.tree().getBody().getStatements();
        for (int k = 0; k < body.size(); k++) {
            if (body.get(k) instanceof ReturnTree end && k == body.size() - 1) {
                atPlace(
                        end,
                        () -> activation.returned =
                                end.getExpression() == null ? null : expressions.compute(end.getExpression()));
            } else {
                run(body.get(k));
            }
        }
        Value result = activation.returned;
        boolean isFloat = method.tree().getReturnType().toString().equals("float");
        activation = caller;
        builder.source = callerSource;
        return isFloat && result != null ? builder.asFloat(result) : result;
    }

    private void declare(VariableTree variable, Value value) {
        String name = variable.getName().toString();
        String type = variable.getType().toString();
        switch (type) {
            case "float" -> activation.values.put(name, builder.asFloat(value));
            case "int" -> activation.values.put(name, withoutBoolean(value));
            case "float[]", "int[]" -> activation.values.put(name, value);
            default -> throw new Refusal(type + " " + name + ": lanes know float, int and the kernel's arrays");
        }
        activation.floats.put(name, type.equals("float"));
    }

    private static Value withoutBoolean(Value value) {
        if (value.kind() == Kind.FLOAT) {
            throw new Refusal("a float where an int is needed");
        }
        return value instanceof Constant(Boolean holds) ? new Constant(holds ? 1 : 0) : value;
    }

    /** Refusals of what is done here get its place. */
    private void atPlace(Tree tree, Runnable something) {
        try {
            something.run();
        } catch (Refusal refusal) {
            throw refusal.at(sources.place(activation.method, tree));
        }
    }

    /** Runs a statement; nothing where there is none. */
    void run(StatementTree statement) {
        if (statement instanceof BlockTree block) {
            block.getStatements().forEach(this::run);
        } else if (statement != null) {
            Activation here = activation;
            try {
                runPlain(statement);
            } catch (Refusal refusal) {
                throw refusal.at(sources.place(here.method, statement));
            }
        }
    }

    private void runPlain(StatementTree statement) {
        switch (statement) {
            case VariableTree variable ->
                declare(
                        variable,
                        variable.getInitializer() == null
                                ? new Constant(0)
                                : expressions.compute(variable.getInitializer()));
            case ExpressionStatementTree expression -> runExpression(expression.getExpression());
            case IfTree choice ->
                choices.run(
                        expressions.compute(choice.getCondition()),
                        choice.getThenStatement(),
                        choice.getElseStatement());
            case WhileLoopTree loop -> loops.run(loop.getCondition(), loop.getStatement(), null);
            case ForLoopTree loop -> loops.run(loop);
            case ReturnTree _ -> throw new Refusal("a return before the method's end");
            default ->
                throw new Refusal(statement.getKind().toString().toLowerCase(java.util.Locale.ROOT)
                        + ": lanes do not know such a statement");
        }
    }

    /** Runs a call, an assignment or a step such as {@code i++}. */
    void runExpression(ExpressionTree tree) {
        switch (tree) {
            case MethodInvocationTree call -> expressions.compute(call);
            case AssignmentTree set -> {
                if (set.getVariable() instanceof ArrayAccessTree place) {
                    store(place, set.getExpression());
                } else {
                    set(set.getVariable(), expressions.compute(set.getExpression()));
                }
            }
            case CompoundAssignmentTree set
            when set.getKind() == Tree.Kind.PLUS_ASSIGNMENT ->
                set(
                        set.getVariable(),
                        new Arithmetic(builder)
                                .add(expressions.compute(set.getVariable()), expressions.compute(set.getExpression())));
            case UnaryTree step
            when step.getKind() == Tree.Kind.POSTFIX_INCREMENT ->
                set(step.getExpression(), expressions.next(expressions.compute(step.getExpression()), 1));
            case UnaryTree step
            when step.getKind() == Tree.Kind.POSTFIX_DECREMENT ->
                set(step.getExpression(), expressions.next(expressions.compute(step.getExpression()), -1));
            default -> throw new Refusal(tree + ": lanes know calls, =, +=, ++ and -- here");
        }
    }

    private void store(ArrayAccessTree place, ExpressionTree value) {
        if (expressions.isInArm()) {
            throw new Refusal("a store inside ?:, && or ||");
        }
        String array = expressions.array(place.getExpression());
        Value at = expressions.compute(place.getIndex());
        new Places(builder).store(array, at, expressions.compute(value));
    }

    private void set(ExpressionTree variable, Value value) {
        if (!(variable instanceof IdentifierTree) || !activation.values.containsKey(variable.toString())) {
            throw new Refusal(variable + " is no local variable");
        }
        String name = variable.toString();
        activation.values.put(name, activation.floats.get(name) ? builder.asFloat(value) : withoutBoolean(value));
    }
}
