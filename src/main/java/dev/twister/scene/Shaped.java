package dev.twister.scene;

import dev.twister.scene.ValueType.Structure;
import java.util.List;
import java.util.function.Predicate;

/**
 * An object of one of two shapes, told apart by a field.
 *
 * @param key a required field of the first shape
 * @param keyed where that field is given
 * @param plain where it is not
 * @param isKeyed whether a record is written in the first shape
 */
record Shaped<R>(String key, Structure<R> keyed, Structure<R> plain, Predicate<R> isKeyed) implements ValueType<R> {
    @Override
    public R read(Place place) {
        Fields fields = place.fields();
        boolean known = keyed.names().contains(key);
        if (fields.find(key).isEmpty()) {
            refuse(
                    fields,
                    keyed,
                    plain,
                    "goes with \"" + key + "\" only, which is not given here; allowed without it: ");
            return plain.read(place, known ? List.of(key) : List.of());
        }
        if (known) {
            refuse(fields, plain, keyed, "and \"" + key + "\" are both given; allowed beside \"" + key + "\": ");
        }
        return keyed.read(place);
    }

    @Override
    public String write(R value) {
        return shape(value).write(value);
    }

    @Override
    public int version(R value) {
        return shape(value).version(value);
    }

    private Structure<R> shape(R value) {
        return isKeyed.test(value) ? keyed : plain;
    }

    private void refuse(Fields fields, Structure<R> other, Structure<R> shape, String what) {
        List<String> allowed =
                shape.names().stream().filter(name -> !name.equals(key)).toList();
        other.names().stream()
                .filter(name -> !shape.names().contains(name))
                .flatMap(name -> fields.find(name).stream())
                .findFirst()
                .ifPresent(place -> {
                    throw place.failure(what + String.join(", ", allowed));
                });
    }
}
