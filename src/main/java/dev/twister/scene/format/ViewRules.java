package dev.twister.scene.format;

import dev.twister.scene.CameraView;
import dev.twister.scene.SceneException;
import java.util.HashSet;
import java.util.List;
import java.util.Set;

/** What the views of a scene have to be to each other. */
final class ViewRules {
    static final String FIELD = "views";
    static final String NAME = "name";

    private ViewRules() {}

    /**
     * @param scene its fields, in the file
     * @throws SceneException if two views have the same name, or a view's field of view is too wide for its projection
     */
    static void check(List<CameraView> views, Fields scene) {
        if (views.isEmpty()) {
            return;
        }
        List<Fields> fields = scene.get(FIELD).items(0, views.size(), "", Place::fields);
        Set<String> before = new HashSet<>();
        for (int index = 0; index < views.size(); index++) {
            CameraRules.check(views.get(index).camera(), fields.get(index));
            if (!before.add(views.get(index).name())) {
                throw fields.get(index).get(NAME).refused("a name that no view before it has");
            }
        }
    }
}
