package dev.twister.scene.format;

import dev.twister.scene.Ground;
import dev.twister.scene.SceneException;
import java.util.Optional;

/** What the plane has to be. */
final class GroundRules {
    private GroundRules() {}

    /**
     * @param plane its fields, in the file
     * @throws SceneException if it emits light
     */
    static void check(Ground ground, Fields plane) {
        if (!ground.material().emission().isNone()) {
            Optional<Place> own = plane.find("emission");
            throw own.isPresent()
                    ? own.get().failure("is given, but the plane cannot emit light; add a quad that does")
                    : plane.get("material")
                            .failure("is a material that emits, but the plane cannot emit light; add a quad that does");
        }
    }
}
