package dev.twister.scene.format;

import dev.twister.scene.format.json.LocatedValue;
import java.util.List;

/** A number or an array of three. */
record NumberOrVector(Decimal number, Array<Double> vector) implements ValueType<List<Double>> {
    @Override
    public List<Double> read(Place place) {
        return place.value() instanceof LocatedValue.NumberValue ? List.of(number.read(place)) : vector.read(place);
    }

    @Override
    public String write(List<Double> value) {
        return value.size() == 1 ? number.write(value.getFirst()) : vector.write(value);
    }
}
