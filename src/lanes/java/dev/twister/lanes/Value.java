package dev.twister.lanes;

import java.util.List;

/** What the compiler knows of an expression's value. */
sealed interface Value {
    /** The same number or condition always: an Integer, a Float or a Boolean. */
    record Constant(Object number) implements Value {
        @Override
        public Kind kind() {
            return number instanceof Float ? Kind.FLOAT : number instanceof Integer ? Kind.INT : Kind.MASK;
        }
    }

    /**
     * The same in all lanes: a Java expression.
     *
     * @param cases its value for each variant that may occur, if that is all it depends on; else empty
     */
    record Uniform(String text, Kind kind, List<Object> cases) implements Value {
        Uniform(String text, Kind kind) {
            this(text, kind, List.of());
        }
    }

    /** A value per lane. */
    record Lanes(Variable variable) implements Value {
        @Override
        public Kind kind() {
            return variable.kind;
        }
    }

    /** An int per lane and a constant, as places in arrays are. */
    record Sum(Variable variable, int constant) implements Value {
        @Override
        public Kind kind() {
            return Kind.INT;
        }
    }

    /** An array by its parameter's name. */
    record Array(String name) implements Value {
        @Override
        public Kind kind() {
            throw new Refusal("an array where a number is needed: " + name);
        }
    }

    Kind kind();

    /** Whether lanes may differ. */
    default boolean varies() {
        return this instanceof Lanes || this instanceof Sum;
    }

    /** Whether it is a condition per lane. */
    default boolean isMask() {
        return this instanceof Lanes && kind() == Kind.MASK;
    }

    /** Whether it is known to be a condition, or one of the ints 1 and 0. */
    default boolean isBit() {
        return isMask()
                || (this instanceof Constant(Object number)
                        && (number instanceof Boolean || number.equals(0) || number.equals(1)));
    }

    /** The Java expression of a value that is the same in all lanes. */
    default String text() {
        return switch (this) {
            case Constant(Object number) -> literal(number);
            case Uniform uniform -> uniform.text();
            default -> throw new Refusal("a value that lanes do not share where they must: " + this);
        };
    }

    private static String literal(Object number) {
        return switch (number) {
            case Float f
            when f.isNaN() || f == Float.NEGATIVE_INFINITY ->
                throw new Refusal("a constant that is not a number, or below all numbers");
            case Float f when f.isInfinite() -> "Float.POSITIVE_INFINITY";
            case Float f -> f < 0 || 1 / f < 0 ? "(" + f + "f)" : f + "f";
            case Integer i -> i < 0 ? "(" + i + ")" : i.toString();
            default -> number.toString();
        };
    }
}
