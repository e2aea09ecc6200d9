package dev.twister.lanes;

import com.sun.source.tree.BinaryTree;
import com.sun.source.tree.Tree;
import dev.twister.lanes.Value.Constant;
import dev.twister.lanes.Value.Lanes;
import dev.twister.lanes.Value.Sum;
import java.util.Map;

/** Java's operators on two numbers. */
record Arithmetic(Builder builder) {
    private static final Map<Tree.Kind, String> NAMES = Map.ofEntries(
            Map.entry(Tree.Kind.PLUS, "Add"),
            Map.entry(Tree.Kind.MINUS, "Subtract"),
            Map.entry(Tree.Kind.MULTIPLY, "Multiply"),
            Map.entry(Tree.Kind.DIVIDE, "Divide"),
            Map.entry(Tree.Kind.REMAINDER, "Remainder"),
            Map.entry(Tree.Kind.AND, "And"),
            Map.entry(Tree.Kind.OR, "Or"),
            Map.entry(Tree.Kind.XOR, "Xor"),
            Map.entry(Tree.Kind.LEFT_SHIFT, "ShiftLeft"),
            Map.entry(Tree.Kind.RIGHT_SHIFT, "ShiftRight"));

    private static final Map<String, String> SYMBOLS = Map.ofEntries(
            Map.entry("Add", "+"),
            Map.entry("Subtract", "-"),
            Map.entry("Multiply", "*"),
            Map.entry("Divide", "/"),
            Map.entry("Remainder", "%"),
            Map.entry("And", "&"),
            Map.entry("Or", "|"),
            Map.entry("Xor", "^"),
            Map.entry("ShiftLeft", "<<"),
            Map.entry("ShiftRight", ">>"));

    Value operate(BinaryTree binary, Value a, Value b) {
        String name = NAMES.get(binary.getKind());
        if (name == null) {
            throw new Refusal(binary + ": lanes do not know this operator");
        }
        return operate(name, a, b);
    }

    private Value operate(String name, Value a, Value b) {
        boolean floats = a.kind() == Kind.FLOAT || b.kind() == Kind.FLOAT;
        if (!a.varies() && !b.varies()) {
            Kind kind = floats ? Kind.FLOAT : Kind.INT;
            boolean conditions = a.kind() == Kind.MASK && b.kind() == Kind.MASK;
            return Uniforms.operate(
                    SYMBOLS.get(name), conditions ? a : builder.as(kind, a), conditions ? b : builder.as(kind, b));
        }
        if (floats) {
            if (name.equals("Remainder")) {
                throw new Refusal("a remainder of floats");
            }
            return builder.add(Kind.FLOAT, "float" + name, builder.asFloat(a), builder.asFloat(b));
        }
        if (a.isMask() || b.isMask()) {
            if (name.equals("And") && areBits(a, b)) {
                return bit(builder.and(builder.asCondition(a), builder.asCondition(b)));
            }
            if (name.equals("Or") && areBits(a, b)) {
                return bit(builder.or(builder.asCondition(a), builder.asCondition(b)));
            }
            if (name.equals("Subtract") && a.equals(new Constant(1))) {
                return builder.not(b);
            }
        }
        return ints(name, a, b);
    }

    /** A condition and an int of all lanes: the kernel combines conditions alone by these operators. */
    private static boolean areBits(Value a, Value b) {
        return (a.isBit() || !a.varies()) && (b.isBit() || !b.varies());
    }

    private static Value bit(Value condition) {
        return condition instanceof Constant(Boolean holds) ? new Constant(holds ? 1 : 0) : condition;
    }

    Value add(Value a, Value b) {
        return operate("Add", a, b);
    }

    private Value ints(String name, Value a, Value b) {
        return switch (name) {
            case "Add" -> sum(a, b);
            case "Subtract" ->
                b instanceof Constant(Integer constant) ? sum(a, new Constant(-constant)) : plain(name, a, b);
            case "Multiply" -> product(builder.asInt(a), builder.asInt(b));
            case "Divide", "Remainder" -> {
                if (!(b instanceof Constant(Integer divisor) && divisor > 0)) {
                    throw new Refusal("a division of ints by something else than a positive constant");
                }
                yield plain(name, a, b);
            }
            default -> plain(name, a, b);
        };
    }

    private Value plain(String name, Value a, Value b) {
        return builder.add(Kind.INT, "int" + name, builder.asInt(a), builder.asInt(b));
    }

    private Value sum(Value a, Value b) {
        if (a instanceof Constant || (b instanceof Sum && !(a instanceof Sum))) {
            return sum(b, a);
        }
        if (b instanceof Constant(Integer constant)) {
            if (a instanceof Sum(Variable variable, int before)) {
                return new Sum(variable, before + constant);
            }
            Value number = builder.asInt(a);
            return constant == 0 ? number : new Sum(((Lanes) number).variable(), constant);
        }
        if (a instanceof Sum(Variable variable, int constant)) {
            Value sum = builder.add(Kind.INT, "intAdd", new Lanes(variable), builder.asInt(b));
            return new Sum(((Lanes) sum).variable(), constant);
        }
        return plain("Add", a, b);
    }

    private Value product(Value a, Value b) {
        if (a instanceof Constant) {
            return product(b, a);
        }
        if (b instanceof Constant(Integer factor) && factor > 0 && Integer.bitCount(factor) == 1) {
            int shift = Integer.numberOfTrailingZeros(factor);
            return shift == 0 ? a : builder.add(Kind.INT, "intShiftLeft", a, new Constant(shift));
        }
        return builder.add(Kind.INT, "intMultiply", a, b);
    }
}
