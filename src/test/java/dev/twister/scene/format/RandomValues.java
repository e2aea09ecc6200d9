package dev.twister.scene.format;

import dev.twister.scene.Material;
import dev.twister.scene.TrackTarget;
import dev.twister.scene.property.MaterialProperties;
import dev.twister.scene.property.Range;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Random;

/**
 * Values over the whole ranges of a scene file, by type, from one source of randomness: both ends, round numbers,
 * numbers of every magnitude, and repeated numbers, so that positions coincide. Callers choose the lengths of lists.
 */
final class RandomValues {
    private static final double SMALL = 1e-6;

    /** Of floats. */
    private static final double SMALLEST = 1e-45;

    private static final int MOST_ITEMS = 6;

    private final Random random;
    private final List<Double> before = new ArrayList<>();

    RandomValues(Random random) {
        this.random = random;
    }

    @SuppressWarnings("unchecked") // each type reads what its case gives
    <T> T of(ValueType<T> type) {
        return (T)
                switch (type) {
                    case ValueType.Decimal(Range range) -> number(range);
                    case ValueType.WholeNumber(Range range) -> (int) number(range);
                    case ReflectivityType _ ->
                        Material.DEFAULT.withReflectivity(number(MaterialProperties.REFLECTIVITY.range()));
                    case ValueType.Flag() -> random.nextBoolean();
                    case ValueType.Text _ -> "";
                    case ValueType.GroupName() -> "group-" + random.nextInt(MOST_ITEMS);
                    case ValueType.FilePath _ -> WholeRangeScenes.PICTURE;
                    case ValueType.Version(int newest) -> newest;
                    case ValueType.Choice<?>(Class<?> constants) ->
                        constants.getEnumConstants()[random.nextInt(constants.getEnumConstants().length)];
                    case ValueType.Array<?> array -> items(array);
                    case ValueType.Lines<?>(ValueType.Array<?> array) -> items(array);
                    case ValueType.Converted<?, ?> converted -> decoded(converted);
                    case ValueType.Structure<?> structure -> structure(structure);
                    case Shaped<?> shaped -> of(shaped.plain());
                    case NumberOrVector either -> List.of(of(either.number()));
                    case TrackTargetType _ -> TrackTarget.CAMERA;
                    // Bodies have materials of their own.
                    case Members<?> _ -> new LinkedHashMap<>();
                    case NamedMaterials _ -> Material.DEFAULT;
                };
    }

    private double number(Range range) {
        double number = switch (random.nextInt(10)) {
            case 0 -> random.nextBoolean() ? range.min() : range.max();
            case 1, 2 -> random.nextInt(7) - 3;
            case 3 -> before.isEmpty() ? 0 : before.get(random.nextInt(before.size()));
            case 4 -> range.min() + (range.max() - range.min()) * random.nextDouble();
            default -> ofAnyMagnitude(range);
        };
        double inRange = Math.clamp(number, range.min(), range.max());
        before.add(inRange);
        return inRange;
    }

    private double ofAnyMagnitude(Range range) {
        double largest = Math.max(range.max(), -range.min());
        double smallest = random.nextInt(8) == 0 ? SMALLEST : SMALL;
        double magnitude = largest * Math.pow(smallest / largest, random.nextDouble());
        return random.nextBoolean() ? magnitude : -magnitude;
    }

    private <T> List<T> items(ValueType.Array<T> array) {
        int most = Math.min(array.maxItems(), Math.max(array.minItems(), MOST_ITEMS));
        int count = array.minItems() + random.nextInt(most - array.minItems() + 1);
        List<T> items = new ArrayList<>();
        for (int i = 0; i < count; i++) {
            items.add(of(array.item()));
        }
        return items;
    }

    private <S, T> T decoded(ValueType.Converted<S, T> converted) {
        return converted.decode().apply(of(converted.stored()));
    }

    private <R> R structure(ValueType.Structure<R> structure) {
        R record = structure.defaults();
        for (Field<R, ?> field : structure.fields()) {
            record = withAny(record, field);
        }
        return record;
    }

    private <R, T> R withAny(R record, Field<R, T> field) {
        boolean leftOut = switch (field.presence()) {
            case SPARSE, IMPLIED -> random.nextBoolean();
            // Mostly one light, as engines draw several in another way.
            case EITHER -> field.name().equals(LightRules.SEVERAL) && random.nextInt(8) > 0;
            case REQUIRED, WRITTEN -> false;
        };
        return leftOut ? record : field.with().apply(record, of(field.type()));
    }
}
