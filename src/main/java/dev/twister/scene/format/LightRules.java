package dev.twister.scene.format;

import dev.twister.scene.Scene;
import dev.twister.scene.SceneException;
import dev.twister.scene.light.LightGroup;
import dev.twister.scene.property.SceneLimits;
import java.util.HashSet;
import java.util.Set;

/** A scene has one light or a list of them, in a few groups. */
final class LightRules {
    static final String ONE = "light";
    static final String SEVERAL = "lights";

    private LightRules() {}

    /**
     * @param scene its fields, in the file
     * @throws SceneException if it has both
     */
    static void check(Fields scene) {
        boolean one = scene.find(ONE).isPresent();
        scene.find(SEVERAL).filter(_ -> one).ifPresent(several -> {
            throw several.failure("and \"" + ONE + "\" are both given; a scene has one of them");
        });
    }

    /**
     * @param fields of the scene, in the file
     * @throws SceneException if all lights are hidden
     */
    static void checkVisible(Scene scene, Fields fields) {
        if (scene.lights().list().stream().allMatch(light -> light.tag().hidden())) {
            throw fields.failure(
                    fields.value().offset(), "$ has hidden lights alone; at least one light must be visible");
        }
    }

    /**
     * @param fields of the scene, in the file
     * @throws SceneException if it has too many groups of lights
     */
    static void checkGroups(Scene scene, Fields fields) {
        Set<String> groups = new HashSet<>();
        scene.lights().list().forEach(light -> groups.add(light.group()));
        scene.materials()
                .values()
                .forEach(material -> groups.add(material.emission().group()));
        scene.allSpheres()
                .forEach(sphere -> groups.add(sphere.material().emission().group()));
        scene.meshes().forEach(mesh -> groups.add(mesh.own().emission().group()));
        groups.remove(LightGroup.NONE);
        if (groups.size() > SceneLimits.MAX_LIGHT_GROUPS) {
            throw fields.failure(
                    fields.value().offset(),
                    "$ has " + groups.size() + " names of light groups; it may have " + SceneLimits.MAX_LIGHT_GROUPS);
        }
    }
}
