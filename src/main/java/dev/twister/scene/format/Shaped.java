package dev.twister.scene.format;

import java.util.List;
import java.util.Optional;
import java.util.function.Predicate;
import java.util.stream.Stream;

/** An object of one of two shapes, told apart by a field. */
final class Shaped<R> implements ObjectType<R> {
    private final String key;
    private final ObjectType<R> keyed;
    private final ObjectType<R> plain;
    private final Predicate<R> isKeyed;
    private final List<String> onlyKeyed;
    private final List<String> onlyPlain;

    private final String alone;
    private final String beside;

    /** The key, where this version of the format has it. */
    private final List<String> keys;

    /**
     * @param key a required field of the first shape
     * @param keyed where that field is given
     * @param plain where it is not
     * @param isKeyed whether a record is written in the first shape
     */
    Shaped(String key, ObjectType<R> keyed, ObjectType<R> plain, Predicate<R> isKeyed) {
        this.key = key;
        this.keyed = keyed;
        this.plain = plain;
        this.isKeyed = isKeyed;
        alone = "goes with \"" + key + "\" only, which is not given here; allowed without it: ";
        beside = "and \"" + key + "\" are both given; allowed beside \"" + key + "\": ";
        keys = keyed.names().stream().filter(key::equals).toList();
        onlyKeyed = without(plain.names(), keyed);
        onlyPlain = without(keyed.names(), plain);
    }

    String key() {
        return key;
    }

    ObjectType<R> keyed() {
        return keyed;
    }

    ObjectType<R> plain() {
        return plain;
    }

    @Override
    public List<String> names() {
        return Stream.concat(keyed.names().stream(), plain.names().stream())
                .distinct()
                .toList();
    }

    @Override
    public R read(Place place) {
        return read(place, List.of());
    }

    @Override
    public R read(Place place, List<String> alternatives) {
        Fields fields = place.fields();
        if (fields.find(key).isEmpty()) {
            refuse(fields, onlyKeyed, alone, plain);
            return plain.read(
                    place, Stream.concat(keys.stream(), alternatives.stream()).toList());
        }
        if (!keys.isEmpty()) {
            refuse(fields, onlyPlain, beside, keyed);
        }
        return keyed.read(place, alternatives);
    }

    @Override
    public String write(R value) {
        return shape(value).write(value);
    }

    @Override
    public int version(R value) {
        return shape(value).version(value);
    }

    private ObjectType<R> shape(R value) {
        return isKeyed.test(value) ? keyed : plain;
    }

    private void refuse(Fields fields, List<String> names, String what, ObjectType<R> shape) {
        for (String name : names) {
            Optional<Place> found = fields.find(name);
            if (found.isPresent()) {
                throw found.get().failure(what + String.join(", ", without(List.of(key), shape)));
            }
        }
    }

    private static List<String> without(List<String> names, ObjectType<?> shape) {
        return shape.names().stream().filter(name -> !names.contains(name)).toList();
    }
}
