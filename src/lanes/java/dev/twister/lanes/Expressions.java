package dev.twister.lanes;

import com.sun.source.tree.ArrayAccessTree;
import com.sun.source.tree.BinaryTree;
import com.sun.source.tree.ConditionalExpressionTree;
import com.sun.source.tree.ExpressionTree;
import com.sun.source.tree.IdentifierTree;
import com.sun.source.tree.LiteralTree;
import com.sun.source.tree.MemberSelectTree;
import com.sun.source.tree.MethodInvocationTree;
import com.sun.source.tree.ParenthesizedTree;
import com.sun.source.tree.PrimitiveTypeTree;
import com.sun.source.tree.Tree;
import com.sun.source.tree.TypeCastTree;
import com.sun.source.tree.UnaryTree;
import com.sun.source.util.TreeScanner;
import dev.twister.lanes.Value.Array;
import dev.twister.lanes.Value.Constant;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import javax.lang.model.type.TypeKind;

/** Computes expressions for lanes. */
final class Expressions {
    private static final Map<Tree.Kind, String> COMPARISONS = Map.of(
            Tree.Kind.LESS_THAN, "Less",
            Tree.Kind.LESS_THAN_EQUAL, "NotGreater",
            Tree.Kind.GREATER_THAN, "Greater",
            Tree.Kind.GREATER_THAN_EQUAL, "NotLess",
            Tree.Kind.EQUAL_TO, "Equal",
            Tree.Kind.NOT_EQUAL_TO, "NotEqual");

    private static final Map<String, String> SYMBOLS =
            Map.of("Less", "<", "NotGreater", "<=", "Greater", ">", "NotLess", ">=", "Equal", "==", "NotEqual", "!=");

    private final Sources sources;
    private final Builder builder;
    private final Statements statements;

    /** Number of arms of {@code ?:} around. */
    private int arms;

    /** Calls go to the statements. */
    Expressions(Sources sources, Builder builder, Statements statements) {
        this.sources = sources;
        this.builder = builder;
        this.statements = statements;
    }

    /** Whether the arm of a {@code ?:} is computed, where nothing can be stored. */
    boolean isInArm() {
        return arms > 0;
    }

    Value compute(ExpressionTree tree) {
        return switch (tree) {
            case ParenthesizedTree parentheses -> compute(parentheses.getExpression());
            case LiteralTree literal -> literal(literal);
            case IdentifierTree name -> named(name.getName().toString());
            case MemberSelectTree field ->
                constant(field.getExpression().toString(), field.getIdentifier().toString());
            case TypeCastTree cast -> cast(cast);
            case UnaryTree unary -> unary(unary);
            case BinaryTree binary -> binary(binary);
            case ConditionalExpressionTree choice -> choice(choice);
            case ArrayAccessTree load -> load(load);
            case MethodInvocationTree call -> call(call);
            default -> throw new Refusal(tree + ": lanes do not know such an expression");
        };
    }

    private static Value literal(LiteralTree literal) {
        return switch (literal.getValue()) {
            case Integer _, Float _, Boolean _ -> new Constant(literal.getValue());
            case null, default -> throw new Refusal(literal + ": lanes know ints and floats alone");
        };
    }

    private Value named(String name) {
        Value local = statements.activation().value(name);
        return local != null ? local : constant(statements.activation().method.owner(), name);
    }

    /** A class's constant, whose initializer sees that class's names. */
    private Value constant(String owner, String name) {
        if (owner.equals("Float") && name.equals("POSITIVE_INFINITY")) {
            return new Constant(Float.POSITIVE_INFINITY);
        }
        Value value = statements.inClass(owner, () -> compute(sources.constant(owner, name)));
        if (!(value instanceof Constant)) {
            throw new Refusal(owner + "." + name + " is not a constant");
        }
        return value;
    }

    private Value cast(TypeCastTree cast) {
        TypeKind kind = cast.getType() instanceof PrimitiveTypeTree type ? type.getPrimitiveTypeKind() : TypeKind.ERROR;
        if (cast.getExpression() instanceof MethodInvocationTree call && isRoot(call) && kind == TypeKind.FLOAT) {
            Value square = builder.asFloat(compute(call.getArguments().getFirst()));
            return square.varies()
                    ? builder.add(Kind.FLOAT, "floatRoot", square)
                    : new Value.Uniform("(float) Math.sqrt(" + square.text() + ")", Kind.FLOAT);
        }
        Value value = compute(cast.getExpression());
        return switch (kind) {
            case INT -> builder.truncated(value);
            case FLOAT -> builder.asFloat(value);
            default -> throw new Refusal(cast + ": lanes know ints and floats alone");
        };
    }

    private static boolean isRoot(MethodInvocationTree call) {
        return call.getMethodSelect().toString().equals("Math.sqrt");
    }

    private Value unary(UnaryTree unary) {
        Value value = compute(unary.getExpression());
        return switch (unary.getKind()) {
            case LOGICAL_COMPLEMENT -> builder.not(value);
            case UNARY_MINUS -> negated(value);
            default -> throw new Refusal(unary + ": lanes do not know this operator here");
        };
    }

    private Value negated(Value value) {
        if (!value.varies()) {
            return Uniforms.negated(value);
        }
        return value.kind() == Kind.FLOAT
                ? builder.add(Kind.FLOAT, "floatNegate", value)
                : builder.add(Kind.INT, "intSubtract", new Constant(0), builder.asInt(value));
    }

    private Value binary(BinaryTree binary) {
        Value a = compute(binary.getLeftOperand());
        if (binary.getKind() == Tree.Kind.CONDITIONAL_AND || binary.getKind() == Tree.Kind.CONDITIONAL_OR) {
            return shortened(binary, a);
        }
        Value b = compute(binary.getRightOperand());
        String comparison = COMPARISONS.get(binary.getKind());
        return comparison != null ? compare(comparison, a, b) : new Arithmetic(builder).operate(binary, a, b);
    }

    /** {@code &&} and {@code ||}. */
    private Value shortened(BinaryTree binary, Value a) {
        boolean both = binary.getKind() == Tree.Kind.CONDITIONAL_AND;
        if (a instanceof Constant(Boolean holds)) {
            return holds == both ? compute(binary.getRightOperand()) : a;
        }
        Value b = arm(both ? a : builder.not(a), binary.getRightOperand());
        return both ? builder.and(a, b) : builder.or(a, b);
    }

    private Value compare(String comparison, Value a, Value b) {
        boolean floats = a.kind() == Kind.FLOAT || b.kind() == Kind.FLOAT;
        if (!a.varies() && !b.varies()) {
            Kind kind = floats ? Kind.FLOAT : Kind.INT;
            return Uniforms.compare(SYMBOLS.get(comparison), builder.as(kind, a), builder.as(kind, b));
        }
        if (floats) {
            return builder.add(Kind.MASK, "float" + comparison, builder.asFloat(a), builder.asFloat(b));
        }
        if (a.isMask() && b.equals(new Constant(0)) && comparison.endsWith("Equal")) {
            return comparison.equals("Equal") ? builder.not(a) : a;
        }
        return builder.add(Kind.MASK, "int" + comparison, builder.asInt(a), builder.asInt(b));
    }

    private Value choice(ConditionalExpressionTree choice) {
        Value condition = compute(choice.getCondition());
        if (condition instanceof Constant(Boolean holds)) {
            return compute(holds ? choice.getTrueExpression() : choice.getFalseExpression());
        }
        Value a = arm(condition, choice.getTrueExpression());
        Value b = arm(builder.not(condition), choice.getFalseExpression());
        return builder.choose(condition, a, b);
    }

    /** An expression of which only lanes where the condition holds are used; others do not load. */
    private Value arm(Value condition, ExpressionTree tree) {
        arms++;
        Value value = condition.varies() && loads(tree)
                ? builder.within(builder.narrowed(condition), () -> compute(tree))
                : compute(tree);
        arms--;
        return value;
    }

    /** Whether the expression may load at places that vary. */
    private boolean loads(ExpressionTree tree) {
        boolean[] found = {false};
        new TreeScanner<Void, Void>() {
            @Override
            public Void visitArrayAccess(ArrayAccessTree access, Void nothing) {
                found[0] |= !isPath(access.getExpression());
                return super.visitArrayAccess(access, null);
            }

            @Override
            public Void visitMethodInvocation(MethodInvocationTree call, Void nothing) {
                for (ExpressionTree argument : call.getArguments()) {
                    found[0] |= argument instanceof IdentifierTree name
                            && statements.activation().value(name.getName().toString()) instanceof Array
                            && !isPath(argument);
                }
                return super.visitMethodInvocation(call, null);
            }
        }.scan(tree, null);
        return found[0];
    }

    private boolean isPath(ExpressionTree array) {
        return array(array).equals(Places.PATH);
    }

    /** The name of an array. */
    String array(ExpressionTree tree) {
        if (tree instanceof IdentifierTree name
                && statements.activation().value(name.getName().toString()) instanceof Array(String array)) {
            return array;
        }
        throw new Refusal(tree + " is not one of the kernel's arrays");
    }

    private Value load(ArrayAccessTree access) {
        String array = array(access.getExpression());
        return new Places(builder).load(array, compute(access.getIndex()));
    }

    private Value call(MethodInvocationTree call) {
        String name = call.getMethodSelect().toString();
        List<Value> arguments = new ArrayList<>();
        for (ExpressionTree argument : call.getArguments()) {
            arguments.add(compute(argument));
        }
        if (name.startsWith("Math.")) {
            return math(name.substring("Math.".length()), arguments);
        }
        String owner = call.getMethodSelect() instanceof MemberSelectTree select
                ? select.getExpression().toString()
                : statements.activation().method.owner();
        return statements.call(
                sources.method(owner, name.substring(name.lastIndexOf('.') + 1), arguments.size()), arguments);
    }

    private Value math(String name, List<Value> arguments) {
        Value a = arguments.getFirst();
        Value b = arguments.getLast();
        Kind kind = a.kind() == Kind.FLOAT || b.kind() == Kind.FLOAT ? Kind.FLOAT : Kind.INT;
        String operation = switch (name) {
            case "abs" -> "Absolute";
            case "max" -> "Max";
            case "min" -> "Min";
            default -> throw new Refusal("Math." + name + ": lanes know abs, max, min and (float) Math.sqrt");
        };
        List<Value> operands =
                arguments.stream().map(argument -> builder.as(kind, argument)).toList();
        if (operands.stream().noneMatch(Value::varies)) {
            String text = String.join(", ", operands.stream().map(Value::text).toList());
            return new Value.Uniform("Math." + name + "(" + text + ")", kind);
        }
        return builder.add(kind, (kind == Kind.FLOAT ? "float" : "int") + operation, operands.toArray());
    }

    /** A number that is one larger, or one smaller. */
    Value next(Value value, int by) {
        return new Arithmetic(builder).add(value, new Constant(by));
    }
}
