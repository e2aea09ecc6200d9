package dev.twister.scene;

import java.util.function.BiFunction;
import java.util.function.Function;

/**
 * One field of an object in a scene file.
 *
 * @param <R> the record that the object is read as
 * @param <T> the field's value
 * @param get the record's value
 * @param with the record with another value
 */
record Field<R, T>(String name, Presence presence, ValueType<T> type, Function<R, T> get, BiFunction<R, T, R> with) {
    /** Where a field stands. */
    enum Presence {
        /** In every file. */
        REQUIRED,
        /** In every file that is written; a file that is read may leave it out. */
        WRITTEN,
        /** Only where its value is not what a file that leaves it out gets. */
        SPARSE
    }

    static <R, T> Field<R, T> required(String name, ValueType<T> type, Function<R, T> get, BiFunction<R, T, R> with) {
        return new Field<>(name, Presence.REQUIRED, type, get, with);
    }

    static <R, T> Field<R, T> written(String name, ValueType<T> type, Function<R, T> get, BiFunction<R, T, R> with) {
        return new Field<>(name, Presence.WRITTEN, type, get, with);
    }

    static <R, T> Field<R, T> sparse(String name, ValueType<T> type, Function<R, T> get, BiFunction<R, T, R> with) {
        return new Field<>(name, Presence.SPARSE, type, get, with);
    }

    boolean isRequired() {
        return presence == Presence.REQUIRED;
    }

    /** The record with the value that stands at a place. */
    R read(R record, Place place) {
        return with.apply(record, type.read(place));
    }

    /** Whether the field is left out of the text of a record, as a default says the same. */
    boolean isLeftOut(R record, R defaults) {
        return presence == Presence.SPARSE && get.apply(record).equals(get.apply(defaults));
    }

    String write(R record) {
        return JsonText.member(name, type.write(get.apply(record)));
    }
}
