package dev.twister.gui.property;

import dev.twister.scene.Material;
import dev.twister.scene.Scene;
import dev.twister.scene.light.LightShape;
import dev.twister.scene.property.CameraProperties;
import dev.twister.scene.property.LightProperties;
import dev.twister.scene.property.MaterialProperties;
import java.util.List;
import java.util.stream.Stream;

/** The numbers of the panel's rows for one light or material, for tests. */
public final class PanelNumbers {
    private PanelNumbers() {}

    public static List<NumberProperty<Scene>> ofLight(int index) {
        return LightProperties.ALL.stream()
                .filter(property -> LightProperties.has(LightShape.Kind.SPHERE, property.name()))
                .flatMap(property -> PropertyNumbers.ofLight(property, () -> index))
                .toList();
    }

    public static NumberProperty<Scene> ofLight(int index, String label) {
        return ofLight(index).stream()
                .filter(number -> number.label().equals(label))
                .findFirst()
                .orElseThrow();
    }

    public static List<NumberProperty<Material>> ofMaterial() {
        return MaterialProperties.ALL.stream()
                .flatMap(property -> property.equals(MaterialProperties.REFLECTIVITY)
                        ? Stream.of(DerivedNumbers.REFLECTIVITY)
                        : PropertyNumbers.of(property).stream())
                .toList();
    }

    /** The numbers of the camera, in the order of the rows: the focal length follows the field of view. */
    public static List<NumberProperty<Scene>> ofCamera() {
        return CameraProperties.ALL.stream()
                .flatMap(property -> Stream.concat(
                        PropertyNumbers.of(property.within(Scene::camera, Scene::withCamera)).stream(),
                        property.equals(CameraProperties.FIELD_OF_VIEW)
                                ? Stream.of(PropertyNumbers.focalLength())
                                : Stream.empty()))
                .toList();
    }
}
