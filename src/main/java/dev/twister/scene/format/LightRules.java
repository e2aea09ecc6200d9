package dev.twister.scene.format;

import dev.twister.scene.SceneException;

/** A scene has one light or a list of them. */
final class LightRules {
    static final String ONE = "light";
    static final String SEVERAL = "lights";

    private LightRules() {}

    /**
     * @param scene its fields, in the file
     * @throws SceneException if it has neither or both
     */
    static void check(Fields scene) {
        boolean one = scene.find(ONE).isPresent();
        scene.find(SEVERAL).filter(_ -> one).ifPresent(several -> {
            throw several.failure("and \"" + ONE + "\" are both given; a scene has one of them");
        });
        if (!one && scene.find(SEVERAL).isEmpty()) {
            throw scene.failure(
                    scene.value().offset(),
                    "$." + ONE + " is missing; a scene has a \"" + ONE + "\" or \"" + SEVERAL + "\"");
        }
    }
}
