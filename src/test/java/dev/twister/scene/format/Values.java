package dev.twister.scene.format;

import dev.twister.scene.Material;
import dev.twister.scene.TrackTarget;
import dev.twister.scene.material.Reflectance;
import dev.twister.scene.property.MaterialProperties;
import dev.twister.scene.property.Range;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.SequencedMap;
import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.Combinators;

/** Any value of a scene file, by type, so that new fields are tested automatically. */
final class Values {
    private static final int MOST_ITEMS = 8;
    private static final int MOST_CHARACTERS = 60;
    private static final List<Path> FILES = List.of(Path.of("sky.hdr"), Path.of("earth.png"));

    private static final Arbitrary<Boolean> FLAGS = Arbitraries.of(List.of(true, false));

    private Values() {}

    @SuppressWarnings("unchecked") // each type reads what its case gives
    static <T> Arbitrary<T> of(ValueType<T> type) {
        return (Arbitrary<T>)
                switch (type) {
                    case ValueType.Decimal(Range range) -> numbers(range);
                    case ValueType.WholeNumber(Range range) ->
                        Arbitraries.integers().between((int) range.min(), (int) range.max());
                    case ReflectivityType(int version) ->
                        Combinators.combine(numbers(MaterialProperties.REFLECTIVITY.range()), FLAGS)
                                .as((number, given) -> Material.DEFAULT
                                        .withReflectivity(number)
                                        .withReflectance(
                                                given && version >= ReflectivityType.METALS_SINCE
                                                        ? Reflectance.CONSTANT
                                                        : Reflectance.MIXED));
                    case ValueType.Flag() -> FLAGS;
                    case ValueType.Text(int min, int max) -> texts(min, max);
                    case ValueType.GroupName() -> Arbitraries.of("", "lamp", "Key_light-2");
                    case ValueType.FilePath _ -> Arbitraries.of(FILES);
                    case ValueType.Version _ -> Arbitraries.just(1);
                    case ValueType.Choice<?>(Class<?> constants) -> Arbitraries.of(constants.getEnumConstants());
                    case ValueType.Array<?> array -> items(array);
                    case ValueType.Lines<?>(ValueType.Array<?> array) -> items(array);
                    case ValueType.Converted<?, ?> converted -> decoded(converted);
                    case ValueType.Structure<?> structure -> records(structure);
                    case Members<?> members -> members(members);
                    case NamedMaterials named -> Arbitraries.of(named.byName().values());
                    case Shaped<?> shaped -> shapes(shaped);
                    case NumberOrVector either -> numbers(either);
                    case TrackTargetType _ -> Arbitraries.just(TrackTarget.CAMERA);
                };
    }

    // With many digits, as arithmetic produces them, and with both ends.
    private static Arbitrary<Double> numbers(Range range) {
        return Arbitraries.oneOf(
                Arbitraries.longs()
                        .map(bits -> range.min() + (range.max() - range.min()) * ((bits >>> 11) * 0x1.0p-53)),
                Arbitraries.of(range.min(), range.max()));
    }

    private static Arbitrary<String> texts(int min, int max) {
        return Arbitraries.strings()
                .ofMinLength(min)
                .ofMaxLength(Math.min(max, MOST_CHARACTERS))
                .filter(text -> text.chars().noneMatch(Character::isISOControl));
    }

    private static <T> Arbitrary<List<T>> items(ValueType.Array<T> array) {
        return of(array.item()).list().ofMinSize(array.minItems()).ofMaxSize(Math.min(array.maxItems(), MOST_ITEMS));
    }

    private static <S, T> Arbitrary<T> decoded(ValueType.Converted<S, T> converted) {
        return of(converted.stored()).map(converted.decode());
    }

    private static <T> Arbitrary<SequencedMap<String, T>> members(Members<T> members) {
        return Combinators.combine(
                        of(members.name()).list().uniqueElements().ofMaxSize(MOST_ITEMS),
                        of(members.type()).list().ofSize(MOST_ITEMS))
                .as((names, values) -> {
                    SequencedMap<String, T> map = new LinkedHashMap<>();
                    names.forEach(name -> map.put(name, values.get(map.size())));
                    return map;
                });
    }

    private static <R> Arbitrary<R> shapes(Shaped<R> shaped) {
        return canBeKeyed(shaped) ? Arbitraries.oneOf(of(shaped.keyed()), of(shaped.plain())) : of(shaped.plain());
    }

    // Omitted in older versions, and where it is the name of a material and no material has one.
    private static boolean canBeKeyed(Shaped<?> shaped) {
        return shaped.keyed().names().contains(shaped.key())
                && !(shaped.keyed() instanceof ValueType.Structure<?> structure
                        && structure.fields().stream()
                                .anyMatch(field -> field.type() instanceof NamedMaterials named
                                        && named.byName().isEmpty()));
    }

    private static Arbitrary<List<Double>> numbers(NumberOrVector either) {
        return Arbitraries.oneOf(of(either.number()).map(List::of), of(either.vector()));
    }

    private static <R> Arbitrary<R> records(ValueType.Structure<R> structure) {
        Arbitrary<R> records = Arbitraries.just(structure.defaults());
        for (Field<R, ?> field : structure.fields()) {
            records = withAny(records, field);
        }
        return records;
    }

    // One chain of fields: a choice between records with and without each would double the work with each field.
    private static <R, T> Arbitrary<R> withAny(Arbitrary<R> records, Field<R, T> field) {
        boolean always = switch (field.presence()) {
            case SPARSE, IMPLIED, EITHER -> false;
            case REQUIRED, WRITTEN -> true;
        };
        return Combinators.combine(records, of(field.type()), always ? Arbitraries.just(true) : FLAGS)
                .as((record, value, given) -> given ? field.with().apply(record, value) : record);
    }
}
