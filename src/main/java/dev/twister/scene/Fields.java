package dev.twister.scene;

import dev.twister.scene.LocatedValue.ObjectValue;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;

/** An object's fields. */
record Fields(Place object, ObjectValue value) {
    /** Refuses a field that is in neither list, and the lack of a required one. */
    Fields check(List<String> required, List<String> optional) {
        for (int i = 0; i < value.names().size(); i++) {
            String name = value.names().get(i);
            if (!required.contains(name) && !optional.contains(name)) {
                throw unknown(name, value.values().get(i).offset(), required, optional);
            }
        }
        for (String name : required) {
            if (!value.names().contains(name)) {
                throw object.source()
                        .failure(
                                value.offset(),
                                path(name) + " is missing; required here: " + String.join(", ", required));
            }
        }
        return this;
    }

    Fields check(List<String> required) {
        return check(required, List.of());
    }

    Optional<Place> find(String name) {
        int index = value.names().indexOf(name);
        return index < 0
                ? Optional.empty()
                : Optional.of(
                        new Place(object.source(), path(name), value.values().get(index)));
    }

    /** A field that {@link #check} has required. */
    Place get(String name) {
        return find(name).orElseThrow();
    }

    private JsonPath path(String name) {
        return new JsonPath.Field(object.path(), name);
    }

    private SceneException unknown(String name, int offset, List<String> required, List<String> optional) {
        List<String> allowed =
                Stream.concat(required.stream(), optional.stream()).toList();
        String guess = NearestName.of(name, allowed)
                .map(nearest -> " (did you mean \"" + nearest + "\"?)")
                .orElse("");
        return object.source()
                .failure(
                        offset,
                        object.path() + " has an unknown field " + Excerpt.quoted(name) + guess + "; allowed here: "
                                + String.join(", ", allowed));
    }
}
