package dev.twister.scene.format;

import dev.twister.scene.CameraKeyframe;
import dev.twister.scene.SceneException;
import dev.twister.scene.format.json.JsonText;
import java.util.List;

/** What the keyframes of a camera have to be to each other. */
final class KeyframeRules {
    static final String FIELD = "keyframes";
    static final String TIME = "time";

    private KeyframeRules() {}

    /**
     * @param camera its fields, in the file
     * @throws SceneException if a keyframe is not later than the one before it
     */
    static void check(List<CameraKeyframe> keyframes, Fields camera) {
        if (keyframes.isEmpty()) {
            return;
        }
        List<Place> times = camera.get(FIELD)
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
