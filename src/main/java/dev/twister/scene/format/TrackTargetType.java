package dev.twister.scene.format;

import dev.twister.scene.SceneException;
import dev.twister.scene.TrackTarget;
import dev.twister.scene.format.json.JsonText;
import dev.twister.scene.format.json.LocatedValue;

/** The path of a part of the scene, such as {@code spheres[3]}. */
record TrackTargetType() implements ValueType<TrackTarget> {
    @Override
    public TrackTarget read(Place place) {
        if (place.value() instanceof LocatedValue.TextValue found) {
            return TrackTarget.parse(found.text()).orElseThrow(() -> refused(place));
        }
        throw refused(place);
    }

    @Override
    public String write(TrackTarget value) {
        return JsonText.string(value.toString());
    }

    private static SceneException refused(Place place) {
        return place.refused(
                "camera, plane, sky, shading, rendering, or an item such as lights[0], spheres[2] or" + " meshes[0]");
    }
}
