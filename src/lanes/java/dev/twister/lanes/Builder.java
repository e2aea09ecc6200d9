package dev.twister.lanes;

import dev.twister.lanes.Statement.Block;
import dev.twister.lanes.Statement.Operation;
import dev.twister.lanes.Value.Constant;
import dev.twister.lanes.Value.Lanes;
import dev.twister.lanes.Value.Sum;
import dev.twister.lanes.Value.Uniform;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Supplier;

/** Adds operations to a block, each only once where its result is known. */
final class Builder {
    /** All variables so far. */
    final List<Variable> variables = new ArrayList<>();

    Block block = new Block();
    Scope scope = Scope.empty();

    /** The kernel's method that is read, for the comments of what is written. */
    String source = "";

    /** The masks of the blocks around, the innermost first. */
    private final ArrayDeque<Variable> masks = new ArrayDeque<>();

    Variable variable(Kind kind, boolean isMutable) {
        Variable variable = new Variable(variables.size(), kind, isMutable);
        variables.add(variable);
        return variable;
    }

    /** The lanes that run. */
    Variable mask() {
        return masks.peek();
    }

    /** Does something for the lanes of a mask. */
    <T> T within(Variable mask, Supplier<T> something) {
        masks.push(mask);
        T result = something.get();
        masks.pop();
        return result;
    }

    /** Adds to another block, with what is known there. */
    <T> T into(Block other, Scope known, Supplier<T> something) {
        Block outerBlock = block;
        Scope outerScope = scope;
        block = other;
        scope = known;
        T result = something.get();
        block = outerBlock;
        scope = outerScope;
        return result;
    }

    /** A value at the end of another block, as a kind. */
    Value atEndOf(Block other, Kind kind, Value value) {
        return into(other, Scope.empty(), () -> as(kind, value));
    }

    Lanes add(Kind kind, String name, Object... arguments) {
        List<Object> key = new ArrayList<>();
        key.add(name);
        for (Object argument : arguments) {
            key.add(argument instanceof Lanes(Variable variable) ? variable : argument);
        }
        Variable result = scope.find(key).orElseGet(() -> {
            Variable made = variable(kind, false);
            block.list().add(new Operation(made, name, List.of(arguments), source));
            scope.keep(key, made);
            return made;
        });
        return new Lanes(result);
    }

    /** Loads, whose result may be another each time. */
    Lanes load(String name, Object... arguments) {
        Variable result = variable(Kind.FLOAT, false);
        block.list().add(new Operation(result, name, List.of(arguments), source));
        return new Lanes(result);
    }

    Value as(Kind kind, Value value) {
        return switch (kind) {
            case FLOAT -> asFloat(value);
            case INT -> asInt(value);
            case MASK -> asCondition(value);
        };
    }

    /** An int that is no condition. */
    Value asInt(Value value) {
        return switch (value) {
            case Sum(Variable variable, int constant) ->
                constant == 0
                        ? new Lanes(variable)
                        : add(Kind.INT, "intAdd", new Lanes(variable), new Constant(constant));
            case Lanes lanes when lanes.isMask() -> add(Kind.INT, "maskToInt", lanes);
            case Constant(Boolean holds) -> new Constant(holds ? 1 : 0);
            case Uniform uniform
            when uniform.kind() == Kind.MASK -> Uniforms.choose(uniform, new Constant(1), new Constant(0), Kind.INT);
            default -> value;
        };
    }

    Value asFloat(Value value) {
        if (value.kind() == Kind.FLOAT) {
            return value;
        }
        if (value.isMask()) {
            return add(Kind.FLOAT, "floatChoose", value, new Constant(1f), new Constant(0f));
        }
        Value number = asInt(value);
        return number.varies() ? add(Kind.FLOAT, "intToFloat", number) : Uniforms.toFloat(number);
    }

    /** A condition of a condition, or of a number that is 1 or 0. */
    Value asCondition(Value value) {
        if (value.kind() == Kind.MASK) {
            return value;
        }
        return value.varies()
                ? add(Kind.MASK, "intNotEqual", asInt(value), new Constant(0))
                : Uniforms.compare("!=", value, new Constant(0));
    }

    /** A float's whole part. */
    Value truncated(Value value) {
        if (value.kind() != Kind.FLOAT) {
            return value;
        }
        if (!value.varies()) {
            return Uniforms.toInt(value);
        }
        Variable variable = ((Lanes) value).variable();
        return block.list().stream()
                .flatMap(statement -> statement instanceof Operation operation
                                && operation.result() == variable
                                && operation.name().equals("intToFloat")
                        ? Optional.of((Value) operation.arguments().getFirst()).stream()
                        : Optional.<Value>empty().stream())
                .findFirst()
                .orElseGet(() -> add(Kind.INT, "floatToInt", value));
    }

    Value not(Value condition) {
        return condition.varies() ? add(Kind.MASK, "maskNot", condition) : Uniforms.not(condition);
    }

    Value and(Value a, Value b) {
        if (a instanceof Constant(Boolean holds)) {
            return holds ? b : a;
        }
        if (b instanceof Constant(Boolean holds)) {
            return holds ? a : b;
        }
        return a.varies() || b.varies() ? add(Kind.MASK, "maskAnd", a, b) : Uniforms.operate("&", a, b);
    }

    Value or(Value a, Value b) {
        if (a instanceof Constant(Boolean holds)) {
            return holds ? a : b;
        }
        if (b instanceof Constant(Boolean holds)) {
            return holds ? b : a;
        }
        return a.varies() || b.varies() ? add(Kind.MASK, "maskOr", a, b) : Uniforms.operate("|", a, b);
    }

    /** The variable of a condition in the running lanes. */
    Variable narrowed(Value condition) {
        return ((Lanes) and(new Lanes(mask()), condition)).variable();
    }

    /** The first value where the condition holds, else the second. */
    Value choose(Value condition, Value a, Value b) {
        if (a.equals(b)) {
            return a;
        }
        if (condition instanceof Constant(Boolean holds)) {
            return holds ? a : b;
        }
        boolean floats = a.kind() == Kind.FLOAT || b.kind() == Kind.FLOAT;
        if (condition instanceof Uniform uniform && !a.varies() && !b.varies()) {
            return Uniforms.choose(uniform, a, b, floats ? Kind.FLOAT : a.kind());
        }
        if (condition.varies() && a.isBit() && b.isBit()) {
            return chooseBit(condition, a, b);
        }
        String varying = condition.varies() ? "Choose" : "Pick";
        return floats
                ? add(Kind.FLOAT, "float" + varying, condition, asFloat(a), asFloat(b))
                : add(Kind.INT, "int" + varying, condition, asInt(a), asInt(b));
    }

    private Value chooseBit(Value condition, Value a, Value b) {
        Value first = asCondition(a);
        Value second = asCondition(b);
        if (first instanceof Constant(Boolean holds) && second instanceof Constant) {
            return holds ? condition : not(condition);
        }
        if (second instanceof Constant(Boolean holds) && !holds) {
            return and(condition, first);
        }
        if (first instanceof Constant(Boolean holds) && holds) {
            return or(condition, second);
        }
        return or(and(condition, first), and(not(condition), second));
    }

    /** Places that are 0 in the other lanes, because the Vector API checks the places of all. */
    Variable safe(Variable places) {
        return scope.safe(places, masks)
                .orElseGet(
                        () -> add(Kind.INT, "safe", new Lanes(places), mask()).variable());
    }

    /** The variable of a value that varies. */
    Sum sum(Value place) {
        if (place instanceof Sum sum && sum.constant() >= 0) {
            return sum;
        }
        return new Sum(((Lanes) asInt(place)).variable(), 0);
    }
}
