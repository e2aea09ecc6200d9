package dev.twister.scene.format;

import dev.twister.scene.SceneException;
import dev.twister.scene.format.json.Excerpt;
import dev.twister.scene.format.json.JsonPath;
import dev.twister.scene.format.json.LocatedValue;
import dev.twister.scene.format.json.LocatedValue.ArrayValue;
import dev.twister.scene.format.json.LocatedValue.FlagValue;
import dev.twister.scene.format.json.LocatedValue.NullValue;
import dev.twister.scene.format.json.LocatedValue.NumberValue;
import dev.twister.scene.format.json.LocatedValue.ObjectValue;
import dev.twister.scene.format.json.LocatedValue.TextValue;
import dev.twister.scene.format.json.SourceText;
import dev.twister.scene.property.Range;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Function;

/** A value in a scene file with its path: what it is read as, one method a type, or a message that says why not. */
record Place(SourceText source, JsonPath path, LocatedValue value) {
    double number(Range range) {
        if (value instanceof NumberValue found && range.contains(found.number())) {
            return found.number();
        }
        throw refused("a number " + range);
    }

    /** A number without a fraction, however it is written: JSON has 8, 8.0 and 0.8e1 alike. */
    int wholeNumber(Range range) {
        if (value instanceof NumberValue found
                && range.contains(found.number())
                && found.number() == Math.rint(found.number())) {
            return (int) found.number();
        }
        throw refused("a whole number " + range);
    }

    boolean flag() {
        if (value instanceof FlagValue found) {
            return found.flag();
        }
        throw refused("true or false");
    }

    String oneOf(List<String> allowed) {
        if (value instanceof TextValue found && allowed.contains(found.text())) {
            return found.text();
        }
        throw refused("one of \"" + String.join("\", \"", allowed) + "\"");
    }

    /** An array, each item read by the same method. */
    <T> List<T> items(int minCount, int maxCount, String allowed, Function<Place, T> item) {
        if (value instanceof ArrayValue(int _, List<LocatedValue> found)
                && found.size() >= minCount
                && found.size() <= maxCount) {
            List<T> items = new ArrayList<>(found.size());
            Problems problems = new Problems();
            for (int i = 0; i < found.size() && !problems.isFull(); i++) {
                Place place = new Place(source, new JsonPath.Item(path, i), found.get(i));
                problems.read(() -> item.apply(place)).ifPresent(items::add);
            }
            problems.refuse();
            return items;
        }
        throw refused(allowed);
    }

    Fields fields() {
        if (value instanceof ObjectValue found) {
            return new Fields(this, found);
        }
        throw refused("an object");
    }

    SceneException refused(String allowed) {
        return failure("is " + description() + ", but must be " + allowed);
    }

    SceneException failure(String what) {
        return source.failure(value.offset(), path + " " + what);
    }

    private String description() {
        return switch (value) {
            case ObjectValue _ -> "an object";
            case ArrayValue(int _, List<LocatedValue> items) ->
                "an array of " + items.size() + (items.size() == 1 ? " item" : " items");
            case NumberValue found -> Excerpt.shortened(source.word(found.offset()));
            case TextValue found
            when found.text().length() > 1000 ->
                "a string of " + found.text().length() + " characters, " + Excerpt.quoted(found.text());
            case TextValue found -> Excerpt.quoted(found.text());
            case FlagValue found -> String.valueOf(found.flag());
            case NullValue _ -> "null";
        };
    }
}
