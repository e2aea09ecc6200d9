package dev.twister.lanes;

import dev.twister.lanes.Statement.Operation;
import dev.twister.lanes.Value.Constant;
import dev.twister.lanes.Value.Lanes;
import dev.twister.lanes.Value.Sum;
import java.util.List;
import java.util.Map;

/** Writes operations as Java on the Vector API. */
final class OperationText {
    /** Width of a column in floats, for every number of lanes. */
    static final int WIDTH = 16;

    private static final Map<String, String> COMPARISONS =
            Map.of("Less", "LT", "NotGreater", "LE", "Greater", "GT", "NotLess", "GE", "Equal", "EQ", "NotEqual", "NE");

    /** The comparison of exchanged sides. */
    private static final Map<String, String> EXCHANGED =
            Map.of("LT", "GT", "LE", "GE", "GT", "LT", "GE", "LE", "EQ", "EQ", "NE", "NE");

    private static final Map<String, String> METHODS = Map.ofEntries(
            Map.entry("Add", "add"),
            Map.entry("Subtract", "sub"),
            Map.entry("Multiply", "mul"),
            Map.entry("Divide", "div"),
            Map.entry("Max", "max"),
            Map.entry("Min", "min"),
            Map.entry("And", "and"),
            Map.entry("Or", "or"),
            Map.entry("Negate", "neg"),
            Map.entry("Absolute", "abs"),
            Map.entry("Root", "sqrt"));

    private static final Map<String, String> OPERATORS =
            Map.of("Xor", "XOR", "ShiftLeft", "LSHL", "ShiftRight", "ASHR");

    private OperationText() {}

    /** The place of a variable's column in memory. */
    static String place(Variable variable) {
        return switch (variable.kind) {
            case FLOAT -> "floats, f + " + WIDTH * variable.column;
            case INT -> "ints, i + " + WIDTH * variable.column;
            case MASK -> "masks[m + " + variable.column + "]";
        };
    }

    /** A value as lanes. */
    static String lanes(Kind kind, Object value) {
        if (value instanceof Lanes || value instanceof Sum || value instanceof Variable) {
            return any(value);
        }
        String text = ((Value) value).text();
        return switch (kind) {
            case FLOAT -> "FloatVector.broadcast(FLOATS, " + text + ")";
            case INT -> "IntVector.broadcast(INTS, " + text + ")";
            case MASK -> "FLOATS.maskAll(" + text + ")";
        };
    }

    /** A value as lanes, or as a number that all lanes share. */
    static String any(Object value) {
        return switch (value) {
            case Variable variable -> variable.toString();
            case Lanes(Variable variable) -> variable.toString();
            case Sum(Variable variable, int constant) -> variable + ".add(" + constant + ")";
            default -> ((Value) value).text();
        };
    }

    static String of(Operation operation) {
        List<Object> arguments = operation.arguments();
        String name = operation.name();
        String a = any0(arguments.getFirst());
        return switch (name) {
            case "intDivide" -> quotient(a, divisor(arguments));
            case "intRemainder" ->
                a + ".sub((" + quotient(a, divisor(arguments)) + ").mul(" + divisor(arguments) + "))";
            case "intToFloat" -> "(FloatVector) " + a + ".convertShape(VectorOperators.I2F, FLOATS, 0)";
            case "floatToInt" -> "(IntVector) " + a + ".convertShape(VectorOperators.F2I, INTS, 0)";
            case "maskToInt" -> "IntVector.zero(INTS).blend(1, " + a + ".cast(INTS))";
            case "floatChoose" ->
                lanes(Kind.FLOAT, arguments.get(2)) + ".blend(" + any(arguments.get(1)) + ", " + a + ")";
            case "intChoose" ->
                lanes(Kind.INT, arguments.get(2)) + ".blend(" + any(arguments.get(1)) + ", " + a + ".cast(INTS))";
            case "floatPick", "intPick" -> {
                Kind kind = name.equals("floatPick") ? Kind.FLOAT : Kind.INT;
                yield "(" + a + " ? " + lanes(kind, arguments.get(1)) + " : " + lanes(kind, arguments.get(2)) + ")";
            }
            case "maskAnd" -> commuted("and", Kind.MASK, arguments);
            case "maskOr" -> commuted("or", Kind.MASK, arguments);
            case "maskAndNot" -> a + ".andNot(" + any(arguments.get(1)) + ")";
            case "maskNot" -> a + ".not()";
            case "safe" -> "IntVector.zero(INTS).blend(" + a + ", " + any(arguments.get(1)) + ".cast(INTS))";
            case "scratchPlace" -> a + ".lanewise(VectorOperators.LSHL, 4).add(NUMBERS)";
            case "gather" ->
                "FloatVector.fromArray(FLOATS, " + arguments.get(0) + ", " + arguments.get(2) + ", "
                        + place((Variable) arguments.get(1)) + ")";
            case "scratch" ->
                "FloatVector.fromArray(FLOATS, scratch, s + " + WIDTH * (Integer) arguments.get(1) + ", "
                        + place((Variable) arguments.get(0)) + ")";
            case "scratchAt" ->
                "FloatVector.fromArray(FLOATS, scratch, s + " + WIDTH + " * (" + arguments.get(0) + "))";
            case "path" -> "FloatVector.fromArray(FLOATS, floats, f + " + WIDTH * (Integer) arguments.get(0) + ")";
            default ->
                numeric(
                        name.startsWith("float") ? Kind.FLOAT : Kind.INT,
                        name.replaceFirst("float|int", ""),
                        arguments);
        };
    }

    private static String any0(Object argument) {
        return argument instanceof Value || argument instanceof Variable ? any(argument) : argument.toString();
    }

    private static int divisor(List<Object> arguments) {
        return (Integer) ((Constant) arguments.get(1)).number();
    }

    /** Exact below 2^23. */
    private static String quotient(String a, int divisor) {
        return divisor == 2
                ? a + ".add(" + a + ".lanewise(VectorOperators.LSHR, 31)).lanewise(VectorOperators.ASHR, 1)"
                : "(IntVector) ((FloatVector) " + a + ".convertShape(VectorOperators.I2F, FLOATS, 0)).div(" + divisor
                        + "f).convertShape(VectorOperators.F2I, INTS, 0)";
    }

    private static boolean isShared(Object value) {
        return value instanceof Value number && !number.varies();
    }

    private static String commuted(String method, Kind kind, List<Object> arguments) {
        Object a = arguments.get(0);
        Object b = arguments.get(1);
        Object receiver = isShared(a) ? b : a;
        Object argument = isShared(a) ? a : b;
        return any(receiver) + "." + method + "(" + (kind == Kind.MASK ? lanes(kind, argument) : any(argument)) + ")";
    }

    private static String numeric(Kind kind, String name, List<Object> arguments) {
        String comparison = COMPARISONS.get(name);
        if (comparison != null) {
            return comparison(kind, comparison, arguments.get(0), arguments.get(1));
        }
        if (OPERATORS.containsKey(name)) {
            boolean exchanged = name.equals("Xor") && isShared(arguments.get(0));
            Object a = arguments.get(exchanged ? 1 : 0);
            Object b = arguments.get(exchanged ? 0 : 1);
            return lanes(kind, a) + ".lanewise(VectorOperators." + OPERATORS.get(name) + ", " + any(b) + ")";
        }
        String method = METHODS.get(name);
        if (method == null) {
            throw new Refusal("an unknown operation " + name);
        }
        if (arguments.size() == 1) {
            return any(arguments.getFirst()) + "." + method + "()";
        }
        boolean ordered = name.equals("Subtract") || name.equals("Divide");
        return ordered
                ? lanes(kind, arguments.get(0)) + "." + method + "(" + any(arguments.get(1)) + ")"
                : commuted(method, kind, arguments);
    }

    private static String comparison(Kind kind, String comparison, Object a, Object b) {
        String text = isShared(a)
                ? any(b) + ".compare(VectorOperators." + EXCHANGED.get(comparison) + ", " + any(a) + ")"
                : any(a) + ".compare(VectorOperators." + comparison + ", " + any(b) + ")";
        return kind == Kind.INT ? text + ".cast(FLOATS)" : text;
    }
}
