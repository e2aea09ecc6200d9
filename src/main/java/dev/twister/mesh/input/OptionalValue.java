package dev.twister.mesh.input;

import java.util.Optional;
import java.util.function.BiFunction;

/** What a file may leave out. */
public final class OptionalValue {
    private OptionalValue() {}

    /** The record with a value, or as it is if there is none. */
    public static <R, T> R with(R record, Optional<T> value, BiFunction<R, T, R> wither) {
        return value.map(present -> wither.apply(record, present)).orElse(record);
    }
}
