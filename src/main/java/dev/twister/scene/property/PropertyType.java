package dev.twister.scene.property;

import dev.twister.scene.Rgb;
import dev.twister.scene.Rotation;
import dev.twister.scene.Vector3;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Optional;

/**
 * What a property's values are.
 *
 * @param <V> a value in Java
 */
public sealed interface PropertyType<V> {
    /** Numbers in a row, each in a range: what a track can change. */
    sealed interface Numbers<V> extends PropertyType<V> {
        Range range();

        /** How many: 1 or 3. */
        int count();

        /** In the order of a scene file. */
        List<Double> numbers(V value);

        /** The value that {@link #numbers} gives them for. */
        V of(List<Double> numbers);
    }

    record Decimal(Range range) implements Numbers<Double> {
        @Override
        public int count() {
            return 1;
        }

        @Override
        public List<Double> numbers(Double value) {
            return List.of(value);
        }

        @Override
        public Double of(List<Double> numbers) {
            return numbers.getFirst();
        }
    }

    record Whole(Range range) implements Numbers<Integer> {
        @Override
        public int count() {
            return 1;
        }

        @Override
        public List<Double> numbers(Integer value) {
            return List.of(value.doubleValue());
        }

        @Override
        public Integer of(List<Double> numbers) {
            return (int) Math.rint(numbers.getFirst());
        }
    }

    /** Along the axes x, y and z. */
    record Vector(Range range) implements Numbers<Vector3> {
        @Override
        public int count() {
            return 3;
        }

        @Override
        public List<Double> numbers(Vector3 value) {
            return List.of(value.x(), value.y(), value.z());
        }

        @Override
        public Vector3 of(List<Double> numbers) {
            return new Vector3(numbers.get(0), numbers.get(1), numbers.get(2));
        }
    }

    /** Yaw, pitch and roll. */
    record Turn(Range range) implements Numbers<Rotation> {
        @Override
        public int count() {
            return 3;
        }

        @Override
        public List<Double> numbers(Rotation value) {
            return List.of(value.yawDegrees(), value.pitchDegrees(), value.rollDegrees());
        }

        @Override
        public Rotation of(List<Double> numbers) {
            return new Rotation(numbers.get(0), numbers.get(1), numbers.get(2));
        }
    }

    /** Linear red, green and blue. */
    record Color(Range range) implements Numbers<Rgb> {
        @Override
        public int count() {
            return 3;
        }

        @Override
        public List<Double> numbers(Rgb value) {
            return List.of(value.red(), value.green(), value.blue());
        }

        @Override
        public Rgb of(List<Double> numbers) {
            return new Rgb(numbers.get(0), numbers.get(1), numbers.get(2));
        }
    }

    record Flag() implements PropertyType<Boolean> {}

    /** One of an enum's constants, in lower case. */
    record Choice<E extends Enum<E>>(Class<E> constants) implements PropertyType<E> {
        public List<E> values() {
            return Arrays.asList(constants.getEnumConstants());
        }

        public static String name(Enum<?> constant) {
            return constant.name().toLowerCase(Locale.ROOT);
        }
    }

    /** The name of a layer of light, or nothing. */
    record LayerName() implements PropertyType<String> {}

    /** The name of an animation in a mesh's file, or its number. */
    record ClipName() implements PropertyType<String> {}

    /** A file. */
    record Image() implements PropertyType<Path> {}

    /** A value that may be missing. */
    record Given<V>(PropertyType<V> type) implements PropertyType<Optional<V>> {}
}
