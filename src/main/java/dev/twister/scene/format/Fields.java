package dev.twister.scene.format;

import dev.twister.scene.SceneException;
import dev.twister.scene.format.json.Excerpt;
import dev.twister.scene.format.json.JsonPath;
import dev.twister.scene.format.json.LocatedValue.Member;
import dev.twister.scene.format.json.LocatedValue.ObjectValue;
import dev.twister.scene.format.json.NearestName;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;

/** An object's fields. */
record Fields(Place object, ObjectValue value) {
    /** Adds each field that is in neither list to the problems, and the lack of each required one. */
    void check(List<String> required, List<String> optional, Problems problems) {
        for (Member member : value.members()) {
            if (!required.contains(member.name()) && !optional.contains(member.name())) {
                problems.add(unknown(member, required, optional));
            }
        }
        for (String name : required) {
            if (find(name).isEmpty()) {
                problems.add(failure(
                        value.offset(), path(name) + " is missing; required here: " + String.join(", ", required)));
            }
        }
    }

    Optional<Place> find(String name) {
        for (Member member : value.members()) {
            if (member.name().equals(name)) {
                return Optional.of(at(member));
            }
        }
        return Optional.empty();
    }

    List<Member> members() {
        return value.members();
    }

    Place at(Member member) {
        return new Place(object.source(), path(member.name()), member.value());
    }

    /** A field that {@link #check} has required. */
    Place get(String name) {
        return find(name).orElseThrow();
    }

    private JsonPath path(String name) {
        return new JsonPath.Field(object.path(), name);
    }

    private SceneException unknown(Member member, List<String> required, List<String> optional) {
        List<String> allowed =
                Stream.concat(required.stream(), optional.stream()).toList();
        String guess = NearestName.of(member.name(), allowed)
                .map(nearest -> " (did you mean \"" + nearest + "\"?)")
                .orElse("");
        return failure(
                member.offset(),
                object.path() + " has an unknown field " + Excerpt.quoted(member.name()) + guess + "; allowed here: "
                        + String.join(", ", allowed));
    }

    SceneException failure(int offset, String what) {
        return object.source().failure(offset, what);
    }
}
