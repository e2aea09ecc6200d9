package dev.twister.lanes;

import dev.twister.lanes.Value.Constant;
import dev.twister.lanes.Value.Uniform;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.function.BiFunction;
import java.util.function.BinaryOperator;
import java.util.function.Function;

/** Values that are the same in all lanes: computed now where they are constants, else by Java. */
final class Uniforms {
    private static final Map<String, BinaryOperator<Integer>> INTS = Map.ofEntries(
            Map.entry("+", (a, b) -> a + b),
            Map.entry("-", (a, b) -> a - b),
            Map.entry("*", (a, b) -> a * b),
            Map.entry("/", (a, b) -> a / b),
            Map.entry("%", (a, b) -> a % b),
            Map.entry("&", (a, b) -> a & b),
            Map.entry("|", (a, b) -> a | b),
            Map.entry("^", (a, b) -> a ^ b),
            Map.entry("<<", (a, b) -> a << b),
            Map.entry(">>", (a, b) -> a >> b));

    private static final Map<String, BinaryOperator<Float>> FLOATS = Map.of(
            "+", (a, b) -> a + b,
            "-", (a, b) -> a - b,
            "*", (a, b) -> a * b,
            "/", (a, b) -> a / b);

    private Uniforms() {}

    /** The variant, of which these values may occur. */
    static Value variant(String name, List<Integer> values) {
        return known(name, Kind.INT, List.copyOf(values));
    }

    static Value toFloat(Value number) {
        return map(number, "(float) (" + number.text() + ")", Kind.FLOAT, x -> (float) (Integer) x);
    }

    static Value toInt(Value number) {
        return map(number, "(int) (" + number.text() + ")", Kind.INT, x -> (int) (float) (Float) x);
    }

    static Value not(Value condition) {
        return map(condition, "!(" + condition.text() + ")", Kind.MASK, x -> !(Boolean) x);
    }

    static Value negated(Value number) {
        return map(
                number,
                "-(" + number.text() + ")",
                number.kind(),
                x -> x instanceof Float f ? (Object) (-f) : (Object) (-(Integer) x));
    }

    /** An operation on two numbers of one kind, or on two conditions. */
    static Value operate(String symbol, Value a, Value b) {
        return combine(a, b, "(" + a.text() + " " + symbol + " " + b.text() + ")", a.kind(), (x, y) -> switch (x) {
            case Float f -> FLOATS.get(symbol).apply(f, (Float) y);
            case Integer i -> INTS.get(symbol).apply(i, (Integer) y);
            default -> symbol.equals("&") ? (Boolean) x && (Boolean) y : (Boolean) x || (Boolean) y;
        });
    }

    static Value compare(String symbol, Value a, Value b) {
        return combine(a, b, "(" + a.text() + " " + symbol + " " + b.text() + ")", Kind.MASK, (x, y) -> {
            double p = ((Number) x).doubleValue();
            double q = ((Number) y).doubleValue();
            return switch (symbol) {
                case "<" -> p < q;
                case "<=" -> p <= q;
                case ">" -> p > q;
                case ">=" -> p >= q;
                case "==" -> p == q;
                default -> p != q;
            };
        });
    }

    static Value choose(Uniform condition, Value a, Value b, Kind kind) {
        String text = "(" + condition.text() + " ? " + a.text() + " : " + b.text() + ")";
        int count = condition.cases().size();
        if (count == 0 || !isKnown(a, count) || !isKnown(b, count)) {
            return new Uniform(text, kind);
        }
        List<Object> cases = new ArrayList<>();
        for (int k = 0; k < count; k++) {
            cases.add((Boolean) condition.cases().get(k) ? at(a, k) : at(b, k));
        }
        return known(text, kind, cases);
    }

    private static Value map(Value a, String text, Kind kind, Function<Object, Object> function) {
        if (a instanceof Constant(Object number)) {
            return new Constant(function.apply(number));
        }
        return known(text, kind, ((Uniform) a).cases().stream().map(function).toList());
    }

    private static Value combine(
            Value a, Value b, String text, Kind kind, BiFunction<Object, Object, Object> function) {
        if (a instanceof Constant(Object first) && b instanceof Constant(Object second)) {
            return new Constant(function.apply(first, second));
        }
        int count = Math.max(cases(a), cases(b));
        List<Object> cases = new ArrayList<>();
        for (int k = 0; k < count && isKnown(a, count) && isKnown(b, count); k++) {
            cases.add(function.apply(at(a, k), at(b, k)));
        }
        return known(text, kind, cases);
    }

    private static int cases(Value value) {
        return value instanceof Uniform uniform ? uniform.cases().size() : 0;
    }

    private static boolean isKnown(Value value, int count) {
        return value instanceof Constant || cases(value) == count;
    }

    private static Object at(Value value, int index) {
        return value instanceof Constant(Object number)
                ? number
                : ((Uniform) value).cases().get(index);
    }

    /** A constant if all cases are the same. */
    private static Value known(String text, Kind kind, List<? extends Object> cases) {
        boolean same = !cases.isEmpty() && cases.stream().distinct().count() == 1;
        return same ? new Constant(cases.getFirst()) : new Uniform(text, kind, List.copyOf(cases));
    }
}
