package dev.twister.scene.format;

import dev.twister.scene.Keyframe;
import dev.twister.scene.Scene;
import dev.twister.scene.SceneException;
import dev.twister.scene.Track;
import dev.twister.scene.TrackTarget;
import dev.twister.scene.format.json.JsonText;
import dev.twister.scene.property.Property;
import dev.twister.scene.property.TrackProperties;
import java.util.HashSet;
import java.util.List;
import java.util.Set;

/** What the tracks of a scene have to be. */
final class TrackRules {
    static final String FIELD = "tracks";
    static final String TARGET = "target";
    static final String PROPERTY = "property";
    static final String KEYFRAMES = "keyframes";
    static final String TIME = "time";
    static final String VALUE = "value";

    private TrackRules() {}

    /**
     * @param fields of the scene, in the file
     * @throws SceneException if a target or a property is not there, two tracks have the same, or keyframes do not fit
     */
    static void check(Scene scene, Fields fields) {
        List<Track> tracks = scene.tracks();
        if (tracks.isEmpty()) {
            return;
        }
        List<Fields> places = fields.get(FIELD).items(0, tracks.size(), "", Place::fields);
        Set<Track> before = new HashSet<>();
        for (int index = 0; index < tracks.size(); index++) {
            Track track = tracks.get(index);
            Fields place = places.get(index);
            check(scene, track, place);
            if (!before.add(Track.of(track.target(), track.property()))) {
                throw place.get(PROPERTY).refused("a property of " + track.target() + " that no track before it has");
            }
        }
    }

    private static void check(Scene scene, Track track, Fields place) {
        TrackTarget target = track.target();
        if (target.index() >= target.count(scene)) {
            throw place.get(TARGET)
                    .refused(
                            "one of the scene's " + target.kind().label() + ", of which it has " + target.count(scene));
        }
        List<String> names =
                TrackProperties.of(target).stream().map(Property::name).toList();
        if (!names.contains(track.property())) {
            throw place.get(PROPERTY).refused("one of the properties of " + target + ": " + String.join(", ", names));
        }
        Property<Scene, ?> property =
                TrackProperties.find(target, track.property()).orElseThrow();
        List<Fields> keyframes = place.get(KEYFRAMES).items(1, track.keyframes().size(), "", Place::fields);
        for (int index = 0; index < keyframes.size(); index++) {
            check(property, track.keyframes(), index, keyframes.get(index));
        }
    }

    private static void check(Property<Scene, ?> property, List<Keyframe> keyframes, int index, Fields place) {
        Keyframe keyframe = keyframes.get(index);
        boolean fits = keyframe.value().size() == property.count()
                && keyframe.value().stream().allMatch(property.range()::contains);
        if (!fits) {
            throw place.get(VALUE)
                    .refused((property.count() == 1 ? "a number " : "an array of 3 numbers ") + property.range());
        }
        if (index > 0 && keyframe.seconds() <= keyframes.get(index - 1).seconds()) {
            throw place.get(TIME)
                    .refused("above " + JsonText.number(keyframes.get(index - 1).seconds())
                            + ", the time of the keyframe before it");
        }
    }
}
