package dev.twister.scene.format;

import dev.twister.scene.Light;
import dev.twister.scene.Scene;
import dev.twister.scene.SceneException;
import dev.twister.scene.light.LightGroup;
import dev.twister.scene.light.LightShape;
import dev.twister.scene.property.LightProperties;
import dev.twister.scene.property.Property;
import dev.twister.scene.property.PropertyType.Choice;
import dev.twister.scene.property.SceneLimits;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.function.Function;
import java.util.stream.Stream;

/** A scene has one light or a list of them, in a few groups; what each has is by its type. */
final class LightRules {
    static final String ONE = "light";
    static final String SEVERAL = "lights";
    static final String TYPE = "type";
    static final String DIRECTION = "direction";

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
     * @throws SceneException if a light lacks a direction, or has what lights of its type do not have
     */
    static void checkShapes(Scene scene, Fields fields) {
        int count = scene.lights().count();
        List<Place> places = Stream.concat(
                        fields.find(ONE).stream(),
                        fields.find(SEVERAL).stream()
                                .flatMap(several -> several.items(1, count, "", Function.identity()).stream()))
                .toList();
        for (int index = 0; index < Math.min(count, places.size()); index++) {
            Fields light = places.get(index).fields();
            LightShape shape = scene.lights().get(index).shape();
            light.find(TYPE).ifPresent(type -> checkShape(shape, light, type));
        }
    }

    private static void checkShape(LightShape shape, Fields light, Place type) {
        String kind = Choice.name(shape.kind());
        for (Property<Light, ?> property : LightProperties.ALL) {
            light.find(property.name())
                    .filter(_ -> !LightProperties.has(shape.kind(), property.name()))
                    .ifPresent(given -> {
                        throw given.failure("is given, but a light of type \"" + kind + "\" has none");
                    });
        }
        if (LightProperties.has(shape.kind(), DIRECTION)) {
            String expected = "three numbers " + LightProperties.DIRECTION.range() + ", one of them not 0";
            Place given = light.find(DIRECTION)
                    .orElseThrow(() -> type.failure(
                            "is \"" + kind + "\", which needs \"" + DIRECTION + "\": where it shines, " + expected));
            if (shape.direction().length() == 0) {
                throw given.failure("is [0, 0, 0], but must be " + expected);
            }
        }
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
