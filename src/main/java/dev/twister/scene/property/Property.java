package dev.twister.scene.property;

import static java.util.Objects.requireNonNull;

import dev.twister.scene.Integrator;
import dev.twister.scene.Rgb;
import dev.twister.scene.SceneException;
import dev.twister.scene.Vector3;
import dev.twister.scene.property.PropertyType.Choice;
import dev.twister.scene.property.PropertyType.Color;
import dev.twister.scene.property.PropertyType.Decimal;
import dev.twister.scene.property.PropertyType.Flag;
import dev.twister.scene.property.PropertyType.Given;
import dev.twister.scene.property.PropertyType.Image;
import dev.twister.scene.property.PropertyType.Numbers;
import dev.twister.scene.property.PropertyType.Vector;
import dev.twister.scene.property.PropertyType.Whole;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.function.BiFunction;
import java.util.function.Function;
import java.util.function.UnaryOperator;

/**
 * A property of a part of a scene: all that is known of it but what it does. Reader and writer of scene files, their
 * schema and their description, tracks and the window's rows go by the lists of these.
 *
 * @param <T> the part
 * @param <V> a value
 * @param name in a scene file
 * @param wither a copy with another value
 * @param since the version of the format that first has it
 * @param isAlwaysWritten whether it is written where its value is the default, too
 * @param isAnimated whether a track can change it
 * @param meaning a phrase for the description of the format
 * @param row how the window shows it
 */
@Copied
public record Property<T, V>(
        String name,
        PropertyType<V> type,
        Function<T, V> getter,
        BiFunction<T, V, T> wither,
        int since,
        boolean isAlwaysWritten,
        boolean isAnimated,
        String meaning,
        Row row)
        implements PropertyCopy.With<T, V> {
    public Property {
        requireNonNull(row, "row");
    }

    /** A property of the first version, at rest, that a file may leave out. */
    static <T, V> Property<T, V> of(
            String name, PropertyType<V> type, Function<T, V> getter, BiFunction<T, V, T> wither) {
        return new Property<>(name, type, getter, wither, 1, false, false, "", Row.NONE);
    }

    static <T> Property<T, Double> decimal(
            String name, Range range, Function<T, Double> getter, BiFunction<T, Double, T> wither) {
        return of(name, new Decimal(range), getter, wither);
    }

    static <T> Property<T, Integer> whole(
            String name, Range range, Function<T, Integer> getter, BiFunction<T, Integer, T> wither) {
        return of(name, new Whole(range), getter, wither);
    }

    static <T> Property<T, Vector3> vector(
            String name, Range range, Function<T, Vector3> getter, BiFunction<T, Vector3, T> wither) {
        return of(name, new Vector(range), getter, wither);
    }

    static <T> Property<T, Rgb> color(String name, Range range, Function<T, Rgb> getter, BiFunction<T, Rgb, T> wither) {
        return of(name, new Color(range), getter, wither);
    }

    static <T> Property<T, Boolean> flag(String name, Function<T, Boolean> getter, BiFunction<T, Boolean, T> wither) {
        return of(name, new Flag(), getter, wither);
    }

    static <T, E extends Enum<E>> Property<T, E> choice(
            String name, Class<E> constants, Function<T, E> getter, BiFunction<T, E, T> wither) {
        return of(name, new Choice<>(constants), getter, wither);
    }

    /** A file that is not there in most scenes. */
    static <T> Property<T, Optional<Path>> image(
            String name, Function<T, Optional<Path>> getter, BiFunction<T, Optional<Path>, T> wither) {
        return of(name, new Given<>(new Image()), getter, wither);
    }

    Property<T, V> since(int version) {
        return withSince(version);
    }

    /** Written in every file. */
    Property<T, V> written() {
        return withIsAlwaysWritten(true);
    }

    Property<T, V> animated() {
        return withIsAnimated(true);
    }

    Property<T, V> means(String phrase) {
        return withMeaning(phrase);
    }

    /**
     * How the window shows it.
     *
     * @param keys of the row, or of its three rows with spaces between; empty for none
     */
    Property<T, V> row(String label, String hint, String keys) {
        return withRow(new Row(label, hint, keys, row.slide(), row.only()));
    }

    /** The slider's ends, from the least number to the largest. */
    Property<T, V> slide(Slide slide) {
        return withRow(new Row(row.label(), row.hint(), row.keys(), slide, row.only()));
    }

    /** Without effect in pictures of the other integrator. */
    Property<T, V> only(Integrator integrator) {
        return withRow(new Row(row.label(), row.hint(), row.keys(), row.slide(), Optional.of(integrator)));
    }

    /** The same property of something that has this part. */
    public <W> Property<W, V> within(Function<W, T> part, BiFunction<W, T, W> withPart) {
        return in(part, (whole, edit) -> withPart.apply(whole, edit.apply(part.apply(whole))));
    }

    /**
     * The same property, seen from a whole that has this part.
     *
     * @param part finds the part
     * @param editor returns a copy of the whole with one or more of such parts changed
     */
    public <W> Property<W, V> in(Function<W, T> part, BiFunction<W, UnaryOperator<T>, W> editor) {
        return new Property<>(
                name,
                type,
                part.andThen(getter),
                (whole, value) -> editor.apply(whole, old -> wither.apply(old, value)),
                since,
                isAlwaysWritten,
                isAnimated,
                meaning,
                row);
    }

    /** Such properties of something that has this part. */
    public static <W, T> List<Property<W, ?>> within(
            List<Property<T, ?>> properties, Function<W, T> part, BiFunction<W, T, W> withPart) {
        return properties.stream()
                .<Property<W, ?>>map(property -> property.within(part, withPart))
                .toList();
    }

    /** The numbers that it is made of, where it is: 1 or 3, else 0. */
    public int count() {
        return numbers(type).map(Numbers::count).orElse(0);
    }

    /**
     * The range of its numbers.
     *
     * @throws IllegalStateException if it has none
     */
    public Range range() {
        return numbers(type)
                .orElseThrow(() -> new IllegalStateException(name + " has no range"))
                .range();
    }

    /** Its numbers, in the order of a scene file; 1 where it is not given. */
    public List<Double> numbers(T part) {
        return numbers(type, getter.apply(part));
    }

    /** A copy with other numbers, each brought into its range. */
    public T withNumbers(T part, List<Double> numbers) {
        List<Double> allowed = numbers.stream().map(range()::clamp).toList();
        return wither.apply(part, value(type, allowed));
    }

    /** A copy where it is not given; the part itself where it always is. */
    @SuppressWarnings("unchecked") // a property's values are of its type
    public T without(T part) {
        return type instanceof Given<?> ? wither.apply(part, (V) Optional.empty()) : part;
    }

    /**
     * Checks its numbers.
     *
     * @param part what the message calls the part
     * @throws SceneException if one is out of its range; the message names it
     */
    public void requireInRange(String part, T of) {
        List<Double> numbers = numbers(of);
        for (int i = 0; i < numbers.size(); i++) {
            String axis = numbers.size() == 1 ? "" : "." + "xyz".charAt(i);
            range().require(part + "." + name + axis, numbers.get(i));
        }
    }

    private static Optional<Numbers<?>> numbers(PropertyType<?> type) {
        return switch (type) {
            case Numbers<?> numbers -> Optional.of(numbers);
            case Given<?>(PropertyType<?> given) -> numbers(given);
            default -> Optional.empty();
        };
    }

    @SuppressWarnings("unchecked") // a type's values are of its parameter
    private static <V> List<Double> numbers(PropertyType<V> type, V value) {
        return switch (type) {
            case Numbers<V> numbers -> numbers.numbers(value);
            case Given<?> given ->
                ((Optional<Object>) value)
                        .map(present -> numbers((PropertyType<Object>) given.type(), present))
                        .orElse(numbers(given).isPresent() ? List.of(1.0) : List.of());
            default -> List.of();
        };
    }

    @SuppressWarnings("unchecked") // a type's values are of its parameter
    private static <V> V value(PropertyType<V> type, List<Double> numbers) {
        return switch (type) {
            case Numbers<V> known -> known.of(numbers);
            case Given<?>(PropertyType<?> given) -> (V) Optional.of(value(given, numbers));
            default -> throw new IllegalStateException("not made of numbers: " + type);
        };
    }
}
