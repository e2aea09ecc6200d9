package dev.twister.scene.format;

import dev.twister.scene.format.ValueType.Text;
import dev.twister.scene.format.json.Excerpt;
import dev.twister.scene.format.json.JsonText;
import dev.twister.scene.format.json.LocatedValue.Member;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.SequencedMap;

/**
 * An object whose fields have names of the user's, one line per field, at the top level of the document.
 *
 * @param name what a name may be
 * @param limit how many fields there may be
 */
record Members<T>(Text name, ValueType<T> type, int limit) implements ValueType<SequencedMap<String, T>> {
    @Override
    public SequencedMap<String, T> read(Place place) {
        Fields fields = place.fields();
        SequencedMap<String, T> values = new LinkedHashMap<>();
        Problems problems = new Problems();
        for (Member member : fields.members()) {
            if (!name.allows(member.name())) {
                problems.add(fields.failure(
                        member.offset(),
                        place.path() + " has the name " + Excerpt.quoted(member.name()) + ", but a name must be "
                                + name.allowed()));
            }
            problems.read(() -> type.read(fields.at(member))).ifPresent(read -> values.put(member.name(), read));
        }
        problems.refuse();
        return values;
    }

    @Override
    public String write(SequencedMap<String, T> value) {
        List<String> members = new ArrayList<>();
        value.forEach((key, item) -> members.add(JsonText.member(key, type.write(item))));
        return members.isEmpty() ? "{}" : "{\n    " + String.join(",\n    ", members) + "\n  }";
    }

    @Override
    public int version(SequencedMap<String, T> value) {
        return value.values().stream().mapToInt(type::version).max().orElse(1);
    }
}
