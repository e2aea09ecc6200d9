package dev.twister.scene.format;

import dev.twister.scene.format.json.JsonText;
import dev.twister.scene.property.Property;
import java.util.List;
import java.util.Optional;
import java.util.function.BiFunction;
import java.util.function.Function;

/**
 * One field of an object in a scene file.
 *
 * @param <R> the record that the object is read as
 * @param <T> the field's value
 * @param since the version of the format that first has it
 * @param get the record's value
 * @param with the record with another value
 * @param meaning a phrase for the schema, where it is a property's
 */
record Field<R, T>(
        String name,
        Presence presence,
        int since,
        ValueType<T> type,
        Function<R, T> get,
        BiFunction<R, T, R> with,
        String meaning) {
    /** Where a field stands. */
    enum Presence {
        /** In every file. */
        REQUIRED,
        /** In every file that is written; a file that is read may leave it out. */
        WRITTEN,
        /** Only where its value is not what a file that leaves it out gets. */
        SPARSE,
        /** As sparse; files of versions that lack the field mean the same without it. */
        IMPLIED,
        /** One of several, of which a file has exactly one: where its value is not an empty optional. */
        EITHER
    }

    /** The field of a property. */
    static <R, T> Field<R, T> of(Property<R, T> property, NamedFiles files) {
        return new Field<>(
                property.name(),
                property.isAlwaysWritten() ? Presence.WRITTEN : Presence.SPARSE,
                property.since(),
                ValueType.of(property.type(), files),
                property.getter(),
                property.wither(),
                property.meaning());
    }

    static <R> List<Field<R, ?>> of(List<Property<R, ?>> properties, NamedFiles files) {
        return properties.stream()
                .<Field<R, ?>>map(property -> of(property, files))
                .toList();
    }

    static <R, T> Field<R, T> required(String name, ValueType<T> type, Function<R, T> get, BiFunction<R, T, R> with) {
        return new Field<>(name, Presence.REQUIRED, 1, type, get, with, "");
    }

    static <R, T> Field<R, T> written(String name, ValueType<T> type, Function<R, T> get, BiFunction<R, T, R> with) {
        return new Field<>(name, Presence.WRITTEN, 1, type, get, with, "");
    }

    static <R, T> Field<R, T> sparse(String name, ValueType<T> type, Function<R, T> get, BiFunction<R, T, R> with) {
        return new Field<>(name, Presence.SPARSE, 1, type, get, with, "");
    }

    /** A field that a record may be without: left out of a file, its value is empty. */
    static <R, T> Field<R, Optional<T>> optional(
            String name, ValueType<T> type, Function<R, Optional<T>> get, BiFunction<R, T, R> with) {
        return sparse(
                name,
                ValueType.present(type),
                get,
                (record, value) -> value.map(given -> with.apply(record, given)).orElse(record));
    }

    /** The same field, which only files of that version and later may have. */
    Field<R, T> from(int version) {
        return new Field<>(name, presence, version, type, get, with, meaning);
    }

    /** The same field with that meaning. */
    Field<R, T> meaning(String phrase) {
        return new Field<>(name, presence, since, type, get, with, phrase);
    }

    /** The same field, read otherwise. */
    Field<R, T> with(BiFunction<R, T, R> other) {
        return new Field<>(name, presence, since, type, get, other, meaning);
    }

    /** The same field, in every file that is written. */
    Field<R, T> inEachWritten() {
        return new Field<>(name, Presence.WRITTEN, since, type, get, with, meaning);
    }

    /** The same field, of which older versions of the format have the meaning without it. */
    Field<R, T> impliedBefore(int version) {
        return new Field<>(name, Presence.IMPLIED, version, type, get, with, meaning);
    }

    /** The same field, which no file leaves out. */
    Field<R, T> inEveryFile() {
        return new Field<>(name, Presence.REQUIRED, since, type, get, with, meaning);
    }

    /** The same field under another name. */
    Field<R, T> named(String other) {
        return new Field<>(other, presence, since, type, get, with, meaning);
    }

    /** The same field, left out where its value is the default. */
    Field<R, T> orDefault() {
        return new Field<>(name, Presence.SPARSE, since, type, get, with, meaning);
    }

    /** The same field, which a file has, or another one instead. */
    Field<R, T> orOther() {
        return new Field<>(name, Presence.EITHER, since, type, get, with, meaning);
    }

    /** The same field of an object that stands for a record which holds this one's. */
    <S> Field<S, T> within(Function<S, R> part, BiFunction<S, R, S> withPart) {
        return new Field<>(
                name,
                presence,
                since,
                type,
                part.andThen(get),
                (whole, value) -> withPart.apply(whole, with.apply(part.apply(whole), value)),
                meaning);
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
        return switch (presence) {
            case REQUIRED, WRITTEN -> false;
            case SPARSE, IMPLIED -> get.apply(record).equals(get.apply(defaults));
            case EITHER -> get.apply(record).equals(Optional.empty());
        };
    }

    /** The version of the format that the field's value needs. */
    int version(R record) {
        return Math.max(presence == Presence.IMPLIED ? 1 : since, type.version(get.apply(record)));
    }

    String write(R record) {
        return JsonText.member(name, type.write(get.apply(record)));
    }
}
