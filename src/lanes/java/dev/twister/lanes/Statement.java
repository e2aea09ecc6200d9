package dev.twister.lanes;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;

/** What lanes do. */
sealed interface Statement {
    /**
     * Computes a variable.
     *
     * @param name see {@link OperationText}
     * @param arguments values, variables and numbers
     * @param source the kernel's method
     */
    record Operation(Variable result, String name, List<Object> arguments, String source) implements Statement {
        @Override
        public int weight() {
            return switch (name) {
                case "gather", "scratch", "intDivide", "intRemainder" -> 4;
                case "safe", "floatMax", "floatMin" -> 2;
                default -> 1;
            };
        }
    }

    /** Stores one of the path's floats in the mask's lanes. */
    record PathStore(int place, Value value, Variable mask, String source) implements Statement {
        @Override
        public int weight() {
            return 1;
        }
    }

    /**
     * Stores a float of each lane's scratch.
     *
     * @param lanes places per lane, or null where they are the same
     * @param place place where they are the same, else what is added to the lanes' places
     */
    record ScratchStore(Variable lanes, String place, Value value, Variable mask, String source) implements Statement {
        @Override
        public int weight() {
            return 4;
        }
    }

    /** Sets a variable in all lanes. */
    record Assignment(Variable variable, Value value) implements Statement {
        @Override
        public int weight() {
            return 1;
        }
    }

    /** Sets a variable in the mask's lanes. */
    record MaskedAssignment(Variable variable, Value value, Variable mask) implements Statement {
        @Override
        public int weight() {
            return 1;
        }
    }

    /** Takes the lanes where the value does not hold away from a mask. */
    record Narrowing(Variable variable, Value value) implements Statement {
        @Override
        public int weight() {
            return 1;
        }
    }

    /** Runs the body if the mask has a lane. */
    record LaneIf(Variable mask, Block body) implements Statement {
        @Override
        public int weight() {
            return 2 + body.weight();
        }
    }

    /** Runs one of two blocks. */
    record UniformIf(String condition, Block then, Block otherwise) implements Statement {
        @Override
        public int weight() {
            return 1 + then.weight() + otherwise.weight();
        }
    }

    /** Computes the condition, which narrows the mask, then the body, until the mask has no lane. */
    record LaneLoop(Block condition, Variable mask, Block body) implements Statement {
        @Override
        public int weight() {
            return 2 + condition.weight() + body.weight();
        }
    }

    /** A loop whose index is the same in all lanes. */
    record UniformLoop(String index, String from, String condition, String next, Block body) implements Statement {
        @Override
        public int weight() {
            return 1 + body.weight();
        }
    }

    /** Statements in their order. */
    record Block(List<Statement> list) {
        Block() {
            this(new ArrayList<>());
        }

        int weight() {
            return list.stream().mapToInt(Statement::weight).sum();
        }
    }

    /** About the number of vector instructions. */
    int weight();

    /** The blocks inside. */
    default List<Block> blocks() {
        return switch (this) {
            case LaneIf choice -> List.of(choice.body);
            case UniformIf choice -> List.of(choice.then, choice.otherwise);
            case LaneLoop loop -> List.of(loop.condition, loop.body);
            case UniformLoop loop -> List.of(loop.body);
            default -> List.of();
        };
    }

    /** Passes on the variables that the statement itself reads, not those of its blocks. */
    default void forEachRead(Consumer<Variable> reader) {
        switch (this) {
            case Operation operation -> operation.arguments.forEach(argument -> read(argument, reader));
            case PathStore store -> {
                read(store.value, reader);
                reader.accept(store.mask);
            }
            case ScratchStore store -> {
                read(store.value, reader);
                read(store.lanes, reader);
                reader.accept(store.mask);
            }
            case Assignment set -> read(set.value, reader);
            case MaskedAssignment set -> {
                read(set.value, reader);
                reader.accept(set.mask);
                reader.accept(set.variable);
            }
            case Narrowing set -> {
                read(set.value, reader);
                reader.accept(set.variable);
            }
            case LaneIf choice -> reader.accept(choice.mask);
            case LaneLoop loop -> reader.accept(loop.mask);
            case UniformIf _, UniformLoop _ -> {}
        }
    }

    private static void read(Object argument, Consumer<Variable> reader) {
        switch (argument) {
            case Value.Lanes(Variable variable) -> reader.accept(variable);
            case Value.Sum(Variable variable, int _) -> reader.accept(variable);
            case Variable variable -> reader.accept(variable);
            case null, default -> {}
        }
    }

    /** Passes on the mutable variable that the statement itself sets, if it does. */
    default void forEachSet(Consumer<Variable> setter) {
        switch (this) {
            case Assignment set -> setter.accept(set.variable);
            case MaskedAssignment set -> setter.accept(set.variable);
            case Narrowing set -> setter.accept(set.variable);
            default -> {}
        }
    }
}
