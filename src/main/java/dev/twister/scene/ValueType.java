package dev.twister.scene;

import java.io.File;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Function;

/**
 * How a value stands in a scene file.
 *
 * @param <T> what it is read as
 */
sealed interface ValueType<T> {
    /**
     * Reads the value.
     *
     * @throws SceneException if what stands there is not of this type, or out of range
     */
    T read(Place place);

    /** JSON that {@link #read} takes, where the value is in range. */
    String write(T value);

    record Decimal(Range range) implements ValueType<Double> {
        @Override
        public Double read(Place place) {
            return place.number(range);
        }

        @Override
        public String write(Double value) {
            return JsonText.number(value);
        }
    }

    record WholeNumber(Range range) implements ValueType<Integer> {
        @Override
        public Integer read(Place place) {
            return place.wholeNumber(range);
        }

        @Override
        public String write(Integer value) {
            return value.toString();
        }
    }

    record Flag() implements ValueType<Boolean> {
        @Override
        public Boolean read(Place place) {
            return place.flag();
        }

        @Override
        public String write(Boolean value) {
            return value.toString();
        }
    }

    /** Lengths are in code points. */
    record Text(int minLength, int maxLength) implements ValueType<String> {
        @Override
        public String read(Place place) {
            return place.text(minLength, maxLength);
        }

        @Override
        public String write(String value) {
            return JsonText.string(value);
        }
    }

    /** A file's path with forward slashes, so that a scene made on one system reads on every other. */
    record FilePath(Text text) implements ValueType<Path> {
        @Override
        public Path read(Place place) {
            String name = text.read(place);
            try {
                return Path.of(name);
            } catch (InvalidPathException e) {
                throw place.refused("a file's path, relative to the scene file's folder");
            }
        }

        @Override
        public String write(Path value) {
            return text.write(value.toString().replace(File.separatorChar, '/'));
        }
    }

    /** One of an enum's constants, in lower case. */
    record Choice<E extends Enum<E>>(Class<E> constants) implements ValueType<E> {
        List<String> names() {
            return Arrays.stream(constants.getEnumConstants()).map(Choice::name).toList();
        }

        @Override
        public E read(Place place) {
            return Enum.valueOf(constants, place.oneOf(names()).toUpperCase(Locale.ROOT));
        }

        @Override
        public String write(E value) {
            return JsonText.string(name(value));
        }

        private static String name(Enum<?> constant) {
            return constant.name().toLowerCase(Locale.ROOT);
        }
    }

    /** The number of the only version of the format that this program reads. */
    record Version(int number) implements ValueType<Integer> {
        @Override
        public Integer read(Place place) {
            if (!(place.value() instanceof LocatedValue.NumberValue found) || found.number() != number) {
                throw place.refused(number + ", the version of the format that this program reads");
            }
            return number;
        }

        @Override
        public String write(Integer value) {
            return value.toString();
        }
    }

    /**
     * An array.
     *
     * @param allowed what an array of that many items is called in messages
     */
    record Array<T>(ValueType<T> item, int minItems, int maxItems, String allowed) implements ValueType<List<T>> {
        @Override
        public List<T> read(Place place) {
            return place.items(minItems, maxItems, allowed, item::read);
        }

        @Override
        public String write(List<T> value) {
            return JsonText.array(value.stream().map(item::write).toList());
        }
    }

    /** A long array: one line per item, at the top level of the document. */
    record Lines<T>(Array<T> array) implements ValueType<List<T>> {
        @Override
        public List<T> read(Place place) {
            return array.read(place);
        }

        @Override
        public String write(List<T> value) {
            List<String> items = value.stream().map(array.item()::write).toList();
            return items.isEmpty() ? "[]" : "[\n    " + String.join(",\n    ", items) + "\n  ]";
        }
    }

    /** A value of another type that stands for this one. */
    record Converted<S, T>(ValueType<S> stored, Function<S, T> decode, Function<T, S> encode) implements ValueType<T> {
        @Override
        public T read(Place place) {
            return decode.apply(stored.read(place));
        }

        @Override
        public String write(T value) {
            return stored.write(encode.apply(value));
        }
    }

    /**
     * An object.
     *
     * @param defaults has the values of the fields that a file leaves out
     * @param fields in the order in which they are written
     */
    record Structure<R>(R defaults, List<Field<R, ?>> fields) implements ValueType<R> {
        @Override
        public R read(Place place) {
            Fields found = place.fields().check(names(true), names(false));
            R record = defaults;
            for (Field<R, ?> field : fields) {
                Optional<Place> value = found.find(field.name());
                if (value.isPresent()) {
                    record = field.read(record, value.get());
                }
            }
            return record;
        }

        @Override
        public String write(R value) {
            return JsonText.object(members(value));
        }

        /** The fields that are written, as JSON. */
        List<String> members(R value) {
            List<String> members = new ArrayList<>(fields.size());
            for (Field<R, ?> field : fields) {
                if (!field.isLeftOut(value, defaults)) {
                    members.add(field.write(value));
                }
            }
            return members;
        }

        List<String> names(boolean required) {
            return fields.stream()
                    .filter(field -> field.isRequired() == required)
                    .map(Field::name)
                    .toList();
        }
    }

    static ValueType<Vector3> vector(Range range) {
        return new Converted<>(
                new Array<>(new Decimal(range), 3, 3, "an array of 3 numbers [x, y, z]"),
                axes -> new Vector3(axes.get(0), axes.get(1), axes.get(2)),
                vector -> List.of(vector.x(), vector.y(), vector.z()));
    }

    static ValueType<Rgb> color(Range range) {
        return new Converted<>(
                new Array<>(new Decimal(range), 3, 3, "an array of 3 numbers [red, green, blue]"),
                channels -> new Rgb(channels.get(0), channels.get(1), channels.get(2)),
                color -> List.of(color.red(), color.green(), color.blue()));
    }

    /** A value that is there wherever it is written. */
    static <T> ValueType<Optional<T>> present(ValueType<T> type) {
        return new Converted<>(type, Optional::of, Optional::orElseThrow);
    }
}
