package dev.twister.scene.format;

import dev.twister.scene.Camera;
import dev.twister.scene.CameraKeyframe;
import dev.twister.scene.SceneException;
import dev.twister.scene.format.json.JsonText;
import dev.twister.scene.property.CameraProperties;
import dev.twister.scene.property.Range;
import java.util.List;

/** What the properties and keyframes of a camera have to be to each other. */
final class CameraRules {
    static final String KEYFRAMES = "keyframes";
    static final String TIME = "time";

    private CameraRules() {}

    /**
     * @param fields its fields, in the file
     * @throws SceneException if its field of view is too wide for its projection, or a keyframe is not later than the
     *     one before it
     */
    static void check(Camera camera, Fields fields) {
        Range field = CameraProperties.fieldOfView(camera.projection());
        fields.find(CameraProperties.FIELD_OF_VIEW.name()).ifPresent(place -> place.number(field));
        check(camera.keyframes(), fields);
    }

    private static void check(List<CameraKeyframe> keyframes, Fields camera) {
        if (keyframes.isEmpty()) {
            return;
        }
        List<Place> times = camera.get(KEYFRAMES)
                .items(0, keyframes.size(), "", keyframe -> keyframe.fields().get(TIME));
        for (int index = 1; index < times.size(); index++) {
            double before = keyframes.get(index - 1).seconds();
            if (keyframes.get(index).seconds() <= before) {
                throw times.get(index)
                        .refused("above " + JsonText.number(before) + ", the time of the keyframe before it");
            }
        }
    }
}
