package dev.twister.scene.format;

import dev.twister.scene.Rgb;
import dev.twister.scene.SceneException;
import dev.twister.scene.Vector3;
import dev.twister.scene.format.json.Excerpt;
import dev.twister.scene.format.json.JsonText;
import dev.twister.scene.format.json.LocatedValue;
import dev.twister.scene.light.LightGroup;
import dev.twister.scene.property.PropertyType;
import dev.twister.scene.property.Range;
import dev.twister.scene.property.SceneLimits;
import java.io.File;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Function;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.Stream;

/**
 * How a value stands in a scene file.
 *
 * @param <T> what it is read as
 */
sealed interface ValueType<T>
        permits Members,
                NamedMaterials,
                NumberOrVector,
                ObjectType,
                ReflectivityType,
                TrackTargetType,
                ValueType.Array,
                ValueType.Choice,
                ValueType.Converted,
                ValueType.Decimal,
                ValueType.FilePath,
                ValueType.Flag,
                ValueType.GroupName,
                ValueType.Lines,
                ValueType.Text,
                ValueType.Version,
                ValueType.WholeNumber {
    /**
     * Reads the value.
     *
     * @throws SceneException if what stands there is not of this type, or out of range
     */
    T read(Place place);

    /** JSON that {@link #read} takes, where the value is in range. */
    String write(T value);

    /** The oldest version of the format that has what this value needs. */
    default int version(T value) {
        return 1;
    }

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

    /** A string without control characters; lengths are in code points. */
    record Text(int minLength, int maxLength) implements ValueType<String> {
        boolean allows(String text) {
            int length = text.codePointCount(0, text.length());
            boolean plain = text.chars().noneMatch(Character::isISOControl);
            return plain && length >= minLength && length <= maxLength;
        }

        /** Those that are allowed, in messages. */
        String allowed() {
            return "a string of " + minLength + " to " + maxLength + " characters, none of them a control character";
        }

        @Override
        public String read(Place place) {
            if (place.value() instanceof LocatedValue.TextValue found && allows(found.text())) {
                return found.text();
            }
            throw place.refused(allowed());
        }

        @Override
        public String write(String value) {
            return JsonText.string(value);
        }
    }

    /** The name of a group of lights. */
    record GroupName() implements ValueType<String> {
        @Override
        public String read(Place place) {
            if (place.value() instanceof LocatedValue.TextValue found && LightGroup.isName(found.text())) {
                return found.text();
            }
            throw place.refused(
                    "a name of at most " + LightGroup.MAX_NAME_LENGTH + " letters, digits, hyphens and underscores");
        }

        @Override
        public String write(String value) {
            return JsonText.string(value);
        }
    }

    /** A file's path with forward slashes, so that a scene made on one system reads on every other. */
    record FilePath(Text text, NamedFiles files) implements ValueType<Path> {
        @Override
        public Path read(Place place) {
            String name = text.read(place);
            // Windows asks the machine before it says whether the file is there, and tells it who the user is.
            if (name.matches("[/\\\\]{2}.*")) {
                throw place.failure("names a file on another machine, " + Excerpt.quoted(name)
                        + "; copy the file here and name it relative to the scene file's folder");
            }
            try {
                return files.find(place, Path.of(name));
            } catch (InvalidPathException e) {
                throw place.refused("a file's path, relative to the scene file's folder");
            }
        }

        @Override
        public String write(Path value) {
            return text.write(files.name(value).toString().replace(File.separatorChar, '/'));
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

    /** The number of a version of the format that this program reads: the newest, or an older one. */
    record Version(int newest) implements ValueType<Integer> {
        @Override
        public Integer read(Place place) {
            if (place.value() instanceof LocatedValue.NumberValue found
                    && numbers().contains(found.number())) {
                return (int) found.number();
            }
            String older =
                    numbers().stream().limit(newest - 1L).map(JsonText::number).collect(Collectors.joining(", "));
            throw place.refused(older + " or " + newest + ", the versions of the format that this program reads");
        }

        @Override
        public String write(Integer value) {
            return value.toString();
        }

        private List<Double> numbers() {
            return IntStream.rangeClosed(1, newest).asDoubleStream().boxed().toList();
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

        @Override
        public int version(List<T> value) {
            int version = 1;
            for (T each : value) {
                version = Math.max(version, item.version(each));
            }
            return version;
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

        @Override
        public int version(List<T> value) {
            return array.version(value);
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

        @Override
        public int version(T value) {
            return stored.version(encode.apply(value));
        }
    }

    /**
     * An object.
     *
     * @param defaults has the values of the fields that a file leaves out
     * @param fields in the order in which they are written
     * @param newer fields that only later versions of the format have
     */
    record Structure<R>(R defaults, List<Field<R, ?>> fields, List<Field<R, ?>> newer) implements ObjectType<R> {
        /** As every version of the format has it. */
        Structure(R defaults, List<Field<R, ?>> fields) {
            this(defaults, fields, List.of());
        }

        /** As a version of the format has it, of all the fields that it has in any. */
        static <R> Structure<R> of(int version, R defaults, List<Field<R, ?>> fields) {
            return new Structure<>(
                    defaults,
                    fields.stream().filter(field -> field.since() <= version).toList(),
                    fields.stream().filter(field -> field.since() > version).toList());
        }

        @Override
        public R read(Place place) {
            return read(place, List.of());
        }

        @Override
        public R read(Place place, List<String> alternatives) {
            Fields found = place.fields();
            Problems problems = new Problems();
            for (Field<R, ?> field : newer) {
                found.find(field.name())
                        .ifPresent(value -> problems.add(
                                value.failure("needs \"version\": " + field.since() + " at the top of the file")));
            }
            problems.refuse();
            List<String> known =
                    Stream.of(names(false), alternatives).flatMap(List::stream).toList();
            found.check(names(true), known, problems);
            R record = defaults;
            for (Field<R, ?> field : fields) {
                Optional<Place> value = found.find(field.name());
                if (value.isPresent() && !problems.isFull()) {
                    R before = record;
                    record =
                            problems.read(() -> field.read(before, value.get())).orElse(before);
                }
            }
            problems.refuse();
            return record;
        }

        @Override
        public String write(R value) {
            return JsonText.object(members(value));
        }

        @Override
        public int version(R value) {
            int version = 1;
            for (Field<R, ?> field : fields) {
                if (!field.isLeftOut(value, defaults)) {
                    version = Math.max(version, field.version(value));
                }
            }
            return version;
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

        @Override
        public List<String> names() {
            return fields.stream().map(Field::name).toList();
        }
    }

    /** How a property's value stands there. */
    @SuppressWarnings("unchecked") // a type's values are of its parameter
    static <T> ValueType<T> of(PropertyType<T> type, NamedFiles files) {
        return (ValueType<T>)
                switch (type) {
                    case PropertyType.Decimal(Range range) -> new Decimal(range);
                    case PropertyType.Whole(Range range) -> new WholeNumber(range);
                    case PropertyType.Vector vector -> three(vector, "[x, y, z]");
                    case PropertyType.Turn turn -> three(turn, "[yaw, pitch, roll]");
                    case PropertyType.Color color -> three(color, "[red, green, blue]");
                    case PropertyType.Flag() -> new Flag();
                    case PropertyType.Choice<?> choice -> new Choice<>(choice.constants());
                    case PropertyType.LayerName() -> new GroupName();
                    case PropertyType.ClipName() -> new Text(1, SceneLimits.MAX_NAME_LENGTH);
                    case PropertyType.Image() -> new FilePath(new Text(1, SceneLimits.MAX_PATH_LENGTH), files);
                    case PropertyType.Given<?>(PropertyType<?> given) -> present(of(given, files));
                };
    }

    private static <T> ValueType<T> three(PropertyType.Numbers<T> type, String names) {
        return new Converted<>(
                new Array<>(new Decimal(type.range()), 3, 3, "an array of 3 numbers " + names),
                type::of,
                type::numbers);
    }

    static ValueType<Vector3> vector(Range range) {
        return three(new PropertyType.Vector(range), "[x, y, z]");
    }

    static ValueType<Rgb> color(Range range) {
        return three(new PropertyType.Color(range), "[red, green, blue]");
    }

    /** A value that is there wherever it is written. */
    static <T> ValueType<Optional<T>> present(ValueType<T> type) {
        return new Converted<>(type, Optional::of, Optional::orElseThrow);
    }
}
